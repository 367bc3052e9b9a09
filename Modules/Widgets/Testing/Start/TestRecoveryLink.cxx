#include "DrillWindowTest.h"
#include "FieldNodes.h"
#include "StudyRecovery.h"
#include "WholeFile.h"

#include <QSysInfo>

namespace palpate::recovery_link_test
{
namespace
{
// A window that keeps what is not saved, and a folder as a window that died leaves it.
class RecoveryLinkTest : public test::DrillWindowTest
{
protected:
  void SetUp() override
  {
    test::DrillWindowTest::SetUp();
    if (!IsSkipped())
    {
      this->Link = this->Window->KeepRecovery(this->Root);
    }
  }
  void Measure()
  {
    StudyState next = this->Study->State();
    StudyMeasurement line;
    line.Name = "a width";
    line.PointsWorld = {Vector3(1.0, 2.0, 3.0), Vector3(0.1, -5.0, 1e-7)};
    next.Measurements.push_back(line);
    this->Study->Change("Measure", next);
  }
  // As the timer does.
  void Keep()
  {
    this->Link->Keep();
    WaitUntil([this] { return !this->Link->Kept().IsWriting() && this->Link->Kept().HasKept(); });
  }
  std::filesystem::path Folder() const { return this->Link->Kept().Folder(); }
  std::filesystem::path Session() const { return RecoverySession(this->Folder()); }
  // What is kept now, as a process leaves it that was killed.
  std::filesystem::path Die()
  {
    const std::filesystem::path left = this->Root / "left";
    std::filesystem::create_directories(left);
    std::filesystem::copy(this->Folder(), left,
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
    constexpr int NoProcess = 0x7ffffff0; // above the largest id
    WriteWholeFile(left / "lock", std::to_string(NoProcess) + "\npalpate-viewer\n" +
                                      QSysInfo::machineHostName().toStdString() + "\n");
    return left;
  }
  // A second window in the place of the first one, of which the study was given up.
  void StartAgain()
  {
    this->Study->New();
    WaitUntil([this] { return !std::filesystem::exists(this->Folder()); });
    delete this->Link;
    this->Link = this->Window->KeepRecovery(this->Root);
    QApplication::processEvents(); // a layout shows what is new in it later
  }
  bool IsOffered() const { return this->Link->Offer()->isVisible(); }
  QPushButton* Choice(const char* name) const
  {
    return this->Link->Offer()->findChild<QPushButton*>(name);
  }

  std::filesystem::path Root = this->Phantom.Folder / "recovery";
  RecoveryLink* Link = nullptr;
};

TEST_F(RecoveryLinkTest, RecoversStateMeasurementsAndDrilledVoxelsOfADeadWindow)
{
  this->StartDrilling();
  this->Drill(20.0);
  this->Button("start-touch")->click();
  WaitUntil([this] { return !this->Study->IsTouching(); });
  this->Measure();
  const StudyState state = this->Study->State();
  const double removed = this->Removed();
  const std::vector<float> voxels = NodesOf(*this->Shown(), 0);
  this->Keep();
  this->Die();
  this->StartAgain();
  ASSERT_TRUE(this->IsOffered());
  this->Choice("recover")->click();
  this->Settle();
  WaitUntil([this] { return this->Window->Contents().Cuts().size() == 1; });
  EXPECT_EQ(this->Study->State(), state);
  EXPECT_EQ(this->Removed(), removed);
  EXPECT_EQ(NodesOf(*this->Shown(), 0), voxels);
  EXPECT_FALSE(this->IsOffered());
  EXPECT_TRUE(this->Window->isWindowModified());
}

TEST_F(RecoveryLinkTest, RecoveredStudyNeverOverwritesItsFormerFile)
{
  this->OpenPhantom();
  const auto file = this->Phantom.Folder / "case.palpate.json";
  ASSERT_TRUE(this->Study->Save(file));
  const std::string saved = ReadWholeFile(file, 1 << 20);
  this->Measure();
  this->Keep();
  this->Die();
  this->StartAgain();
  this->Choice("recover")->click();
  this->Settle();
  EXPECT_TRUE(this->Window->windowTitle().contains("case.palpate.json (recovered)"));
  this->SavedTo = QString(); // the user cancels
  this->Action("Save")->trigger();
  EXPECT_EQ(ReadWholeFile(file, 1 << 20), saved);
  this->SavedTo = QString::fromStdString(file.string());
  this->Action("Save")->trigger();
  EXPECT_NE(ReadWholeFile(file, 1 << 20), saved);
  EXPECT_FALSE(this->Window->windowTitle().contains("recovered"));
}

TEST_F(RecoveryLinkTest, WindowThatStillRunsIsNotOffered)
{
  this->OpenPhantom();
  this->Measure();
  this->Keep();
  const auto* other = this->Window->KeepRecovery(this->Root);
  QApplication::processEvents();
  EXPECT_FALSE(other->Offer()->isVisible());
  EXPECT_TRUE(std::filesystem::exists(this->Session()));
}

TEST_F(RecoveryLinkTest, OfferedStudyIsNotOfferedByASecondWindow)
{
  this->OpenPhantom();
  this->Measure();
  this->Keep();
  this->Die();
  this->StartAgain();
  ASSERT_TRUE(this->IsOffered());
  const auto* other = this->Window->KeepRecovery(this->Root);
  QApplication::processEvents();
  EXPECT_FALSE(other->Offer()->isVisible());
}

TEST_F(RecoveryLinkTest, DiscardRemovesAndLaterKeeps)
{
  this->OpenPhantom();
  this->Measure();
  this->Keep();
  const auto left = this->Die();
  this->StartAgain();
  this->Choice("recovery-later")->click();
  EXPECT_FALSE(this->IsOffered());
  EXPECT_TRUE(std::filesystem::exists(RecoverySession(left)));
  this->StartAgain();
  ASSERT_TRUE(this->IsOffered());
  this->MayDelete = false;
  this->Choice("recovery-discard")->click();
  EXPECT_TRUE(this->ToDelete.startsWith("A study without a file, kept on "))
      << this->ToDelete.toStdString();
  EXPECT_TRUE(this->IsOffered());
  EXPECT_TRUE(std::filesystem::exists(RecoverySession(left)));
  this->MayDelete = true;
  this->Choice("recovery-discard")->click();
  EXPECT_FALSE(this->IsOffered());
  EXPECT_FALSE(std::filesystem::exists(left));
}

TEST_F(RecoveryLinkTest, SavedOrUndoneStudyIsNotKept)
{
  this->OpenPhantom();
  this->Measure();
  this->Keep();
  ASSERT_TRUE(this->Study->Save(this->Phantom.Folder / "case.palpate.json"));
  WaitUntil([this] { return !std::filesystem::exists(this->Folder()); });
  this->Measure();
  this->Keep();
  this->Study->Undo();
  WaitUntil([this] { return !std::filesystem::exists(this->Folder()); });
}

TEST_F(RecoveryLinkTest, LeavingRemovesAndASignalKeeps)
{
  this->OpenPhantom();
  this->Measure();
  this->Link->End(false);
  EXPECT_TRUE(std::filesystem::exists(this->Session()));
  this->Link->End(true);
  EXPECT_FALSE(std::filesystem::exists(this->Folder()));
}

TEST_F(RecoveryLinkTest, UnwritableFolderIsOneMessage)
{
  WriteWholeFile(this->Root, "a file in place of the folder");
  this->OpenPhantom();
  this->Window->Messages()->Clear();
  this->Measure();
  for (int minute = 0; minute < 3; ++minute)
  {
    this->Link->Keep();
    QApplication::processEvents();
  }
  EXPECT_EQ(this->Messages().rfind("Changes are not kept for a crash", 0), 0U);
  EXPECT_EQ(this->Messages().find('\n'), std::string::npos) << this->Messages();
  std::filesystem::remove(this->Root);
  this->Keep();
  WaitUntil([this] { return this->Messages().empty(); });
}

TEST_F(RecoveryLinkTest, FailureToWriteIsOneMessage)
{
  this->OpenPhantom();
  this->Window->Messages()->Clear();
  std::filesystem::create_directories(this->Session() / "in the way");
  this->Measure();
  for (int minute = 0; minute < 3; ++minute)
  {
    this->Link->Keep();
    WaitUntil([this] { return !this->Link->Kept().IsWriting(); });
  }
  EXPECT_EQ(this->Messages().rfind("Changes are not kept for a crash", 0), 0U);
  EXPECT_EQ(this->Messages().find('\n'), std::string::npos) << this->Messages();
}

TEST_F(RecoveryLinkTest, WaitsForTheDrillToStop)
{
  this->StartDrilling();
  this->Measure();
  this->Key(QEvent::KeyPress, Qt::Key_D);
  WaitUntil([this] { return this->Study->Reading().Newest.IsDrilling; });
  this->Link->Keep();
  EXPECT_FALSE(this->Link->Kept().IsWriting()) << "the stroke would end";
  this->Key(QEvent::KeyRelease, Qt::Key_D);
  WaitUntil([this] { return std::filesystem::exists(this->Session()); });
}

TEST_F(RecoveryLinkTest, DamagedStudyIsAMessageAndCanBeDiscarded)
{
  this->OpenPhantom();
  this->Measure();
  this->Keep();
  const auto left = this->Die();
  WriteWholeFile(RecoverySession(left), "{");
  this->StartAgain();
  this->Choice("recover")->click();
  EXPECT_NE(this->Messages().find("study.palpate.json"), std::string::npos);
  ASSERT_TRUE(this->IsOffered());
  this->Choice("recovery-discard")->click();
  EXPECT_FALSE(std::filesystem::exists(left));
}
} // namespace
} // namespace palpate::recovery_link_test
