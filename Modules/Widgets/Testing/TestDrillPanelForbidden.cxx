#include "DrillPanel.h"
#include "DrillWindowTest.h"
#include "ForbiddenPhantom.h"

#include <future>

namespace palpate::drill_panel_forbidden_test
{
namespace
{
using test::ForbiddenPhantom;

// Twelve labels in the window; only the first is visible and touchable.
class DrillPanelForbiddenTest : public test::DrillWindowTest
{
protected:
  static constexpr int BoneRow = 0;
  static constexpr int NerveRow = 11;
  enum Role
  {
    SoftTissue = 2,
    Forbidden = 3
  };

  std::string Words() const
  {
    return this->Window->findChild<DrillPanel*>()->AlarmWords().toStdString();
  }
  void PressAndRelease()
  {
    QKeyEvent press(QEvent::KeyPress, Qt::Key_D, Qt::NoModifier);
    QApplication::sendEvent(this->Window->Views(), &press);
    this->FeelUntil([this] { return this->Study->Reading().Newest.IsDrilling; });
    QKeyEvent release(QEvent::KeyRelease, Qt::Key_D, Qt::NoModifier);
    QApplication::sendEvent(this->Window->Views(), &release);
    WaitUntil([this] { return !this->Study->Reading().Newest.IsDrilling; });
  }
  void ExpectNothingCut() const
  {
    for (const auto& one : this->Study->Reading().Drill.Drilled)
    {
      EXPECT_EQ(one.RemovedVolume, 0.0);
    }
  }
  void StartDrilling()
  {
    this->Study->OpenSegmentation(this->Labels.File);
    WaitUntil([this] { return this->Study->State().Structures.size() == 12; });
    this->Settle();
    this->Choose(BoneRow, SoftTissue);
    this->Settle();
    this->Button("start-touch")->click();
    WaitUntil([this] { return !this->Study->Reading().Drill.Drilled.empty(); });
  }
  // The study's only worker is blocked until Release.
  void HoldWorker()
  {
    StudyJob job;
    job.IsUrgent = true;
    job.Work = [wait = this->Released.get_future().share()](const ProgressFunction&)
    {
      wait.wait();
      return StudyJob::Delivery([] {});
    };
    this->Study->Current().Jobs().Start(std::move(job));
  }
  void Release() { this->Released.set_value(); }

  ForbiddenPhantom Labels;
  std::promise<void> Released;
};

TEST_F(DrillPanelForbiddenTest, ReportsOnceThatDrillingWaitsForProtection)
{
  this->StartDrilling();
  EXPECT_EQ(this->Words(), "");
  EXPECT_TRUE(this->Button("drill-pedal")->isEnabled());
  this->HoldWorker();
  this->Window->Messages()->Clear();
  this->Choose(NerveRow, Forbidden);
  const std::string waits = "Drilling waits for the protection of label 12.";
  EXPECT_EQ(this->Words(), waits);
  EXPECT_EQ(this->StatusOf(NerveRow), "Protection waits");
  EXPECT_FALSE(this->Button("drill-pedal")->isEnabled());
  EXPECT_EQ(this->Messages(), "");
  this->PressAndRelease();
  this->PressAndRelease();
  const std::string said = this->Messages();
  const std::size_t first = said.find(waits);
  ASSERT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find(waits, first + 1), std::string::npos) << said;
  this->ExpectNothingCut();
  this->Release();
  WaitUntil([this] { return this->Button("drill-pedal")->isEnabled(); });
  EXPECT_EQ(this->Words().find("waits"), std::string::npos) << this->Words();
  EXPECT_NE(this->StatusOf(NerveRow).find("mm away"), std::string::npos)
      << this->StatusOf(NerveRow);
}

TEST_F(DrillPanelForbiddenTest, ShowsProtectionStatusBeforeTouch)
{
  this->Study->OpenSegmentation(this->Labels.File);
  WaitUntil([this] { return this->Study->State().Structures.size() == 12; });
  this->Settle();
  this->Choose(BoneRow, SoftTissue);
  this->Choose(NerveRow, Forbidden);
  WaitUntil([this] { return this->StatusOf(NerveRow) == "Protected"; });
  EXPECT_EQ(this->Words(), "");
}

TEST_F(DrillPanelForbiddenTest, ReportsFailedProtectionOnceWithFix)
{
  this->StartDrilling();
  this->Window->Messages()->Clear();
  StudyState next = this->Study->State();
  next.Structures.push_back(
      test::StudyPhantom::Structure(77, TouchRepresentation::Automatic, next.SegmentationFile));
  next.Structures.back().Name = "Pallidum_L"; // without voxels
  next.Structures.back().IsVisible = false;
  next.Structures.back().IsTouchable = false;
  next.Structures.back().IsForbidden = true;
  this->Study->Change("Forbid what is not there", next);
  const std::string start = "Drilling is off, because Pallidum_L cannot be protected: ";
  WaitUntil([&] { return this->Messages().find(start) != std::string::npos; });
  EXPECT_EQ(this->Words().rfind(start, 0), 0U) << this->Words();
  EXPECT_EQ(this->StatusOf(12).rfind("Not protected: ", 0), 0U) << this->StatusOf(12);
  this->PressAndRelease();
  const std::string said = this->Messages();
  EXPECT_EQ(said.find(start), said.rfind(start)) << said;
  this->ExpectNothingCut();
}

// A nerve in bone: hidden, it is outlined still, since it is protected.
TEST_F(DrillPanelForbiddenTest, ForbiddenStructureIsOutlinedEvenIfHidden)
{
  this->StartDrilling();
  const auto& outlines = this->Window->Contents().Outlines();
  EXPECT_TRUE(outlines.empty());
  this->Choose(NerveRow, Forbidden);
  this->Settle();
  const StudyState& state = this->Study->State();
  const SceneStructure& nerve = state.Structures[NerveRow];
  ASSERT_TRUE(nerve.IsForbidden && !nerve.IsVisible);
  WaitUntil([&] { return outlines.count(nerve.Id) > 0; });
  EXPECT_FALSE(outlines.at(nerve.Id)->GetVisibility());
  EXPECT_TRUE(outlines.at(nerve.Id)->GetForbidden());
  EXPECT_GT(outlines.at(nerve.Id)->GetSurface()->GetNumberOfCells(), 0);
  StudyState next = state;
  next.Structures[NerveRow].IsVisible = true;
  this->Study->Change("Show the nerve", next);
  const auto& surfaces = this->Window->Contents().Surfaces();
  WaitUntil([&] { return surfaces.count(nerve.Id) > 0; });
  EXPECT_TRUE(surfaces.at(nerve.Id)->GetForbidden());
  EXPECT_EQ(outlines.count(nerve.Id), 0U);
}
} // namespace
} // namespace palpate::drill_panel_forbidden_test
