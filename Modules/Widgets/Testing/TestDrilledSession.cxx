#include "DrillWindowTest.h"
#include "FieldNodes.h"
#include "WholeFile.h"

namespace palpate::drilled_session_test
{
namespace
{
// A saved study, in which then a hole is drilled.
class DrilledSessionTest : public test::DrillWindowTest
{
protected:
  void DrillAfterSaving()
  {
    this->StartDrilling();
    this->Save();
    EXPECT_FALSE(this->Window->isWindowModified());
    this->Drill(20.0);
    this->Button("start-touch")->click();
    WaitUntil([this] { return !this->Study->IsTouching(); });
  }
  void Save()
  {
    this->SavedTo = QString::fromStdString(this->File.string());
    this->Action("Save")->trigger();
    ASSERT_TRUE(std::filesystem::exists(this->File)) << this->Messages();
  }
  void Reopen()
  {
    this->Window->Messages()->Clear();
    this->Opened = QStringList(QString::fromStdString(this->File.string()));
    this->Action("Open study")->trigger();
    this->Settle();
    DrawAll(*this->Window->Views());
  }

  std::filesystem::path File = this->Phantom.Folder / "case.palpate.json";
  std::filesystem::path DrilledFile = this->Phantom.Folder / "case.palpate.drill";
};

TEST_F(DrilledSessionTest, LeavingAsksToSaveTheHole)
{
  this->DrillAfterSaving();
  WaitUntil([this] { return this->Window->isWindowModified(); });
  this->Leaving = FileQuestions::Answer::Cancel;
  this->Window->close();
  EXPECT_TRUE(this->Window->isVisible());
  this->Action("New study")->trigger();
  this->Opened = QStringList(QString::fromStdString(this->File.string()));
  this->Action("Open study")->trigger();
  EXPECT_EQ(this->TimesAskedToSave, 3);
  EXPECT_GT(this->Removed(), 20.0) << "nothing was left";
  this->Leaving = FileQuestions::Answer::Save;
  this->Action("New study")->trigger();
  EXPECT_EQ(this->TimesAskedToSave, 4);
  EXPECT_TRUE(std::filesystem::exists(this->DrilledFile));
  this->Window->close();
  EXPECT_EQ(this->TimesAskedToSave, 4) << "it is saved";
}

TEST_F(DrilledSessionTest, ReopenedSessionShowsTheHoleBeforeATouch)
{
  this->DrillAfterSaving();
  this->Save();
  WaitUntil([this] { return !this->Window->isWindowModified(); });
  const double removed = this->Removed();
  const std::vector<float> voxels = NodesOf(*this->Shown(), 0);
  this->Action("New study")->trigger();
  WaitUntil([this] { return this->Window->Contents().Cuts().empty(); });
  this->Reopen();
  WaitUntil([this] { return this->Window->Contents().Cuts().size() == 1; });
  EXPECT_EQ(this->TimesAskedToSave, 0);
  EXPECT_EQ(this->Removed(), removed);
  ASSERT_NE(this->Shown(), nullptr);
  EXPECT_EQ(NodesOf(*this->Shown(), 0), voxels);
  EXPECT_NE(this->StatusOf(0).find("removed"), std::string::npos);
  EXPECT_EQ(this->Messages(), "");
  EXPECT_FALSE(this->Window->isWindowModified());
  this->StartTouch();
  WaitUntil([&] { return this->Removed() == removed; });
  EXPECT_FALSE(this->Button("drill-undo")->isEnabled());
  this->Button("drill-reset")->click();
  WaitUntil([this] { return this->Removed() == 0.0; });
  WaitUntil([this] { return this->Button("drill-undo")->isEnabled(); });
  this->Button("drill-undo")->click();
  WaitUntil([&] { return this->Removed() == removed; });
}

TEST_F(DrilledSessionTest, UnsavedHoleIsNotShownInAReopenedSession)
{
  this->DrillAfterSaving();
  const auto drilled = this->Shown();
  this->Reopen();
  EXPECT_EQ(this->TimesAskedToSave, 1);
  WaitUntil([this] { return this->Window->Contents().Cuts().empty(); });
  EXPECT_NE(this->Shown(), drilled);
  EXPECT_EQ(this->StatusOf(0).find("removed"), std::string::npos);
}

TEST_F(DrilledSessionTest, MalformedHoleIsOneMessage)
{
  this->DrillAfterSaving();
  this->Save();
  const StudyState saved = this->Study->State();
  const std::string bytes = ReadWholeFile(this->DrilledFile, 1 << 28);
  WriteWholeFile(this->DrilledFile, bytes.substr(0, bytes.size() / 2));
  this->Reopen();
  WaitUntil([this] { return !this->Messages().empty(); });
  EXPECT_EQ(this->Study->State(), saved);
  EXPECT_EQ(this->Messages().find('\n'), std::string::npos) << this->Messages();
  EXPECT_NE(this->Messages().find(this->DrilledFile.string()), std::string::npos);
  EXPECT_TRUE(this->Window->Contents().Cuts().empty());
  this->Action("New study")->trigger();
  WaitUntil([this] { return this->Messages().empty(); });
}
} // namespace
} // namespace palpate::drilled_session_test
