#include "TutorialWindow.h"

#include <QDoubleSpinBox>
#include <QSlider>
#include <QTableWidget>

namespace palpate::tutorial_test
{
namespace
{
// Documentation/Tutorial/FeelAProstate.md.
class TutorialTest : public test::TutorialWindow
{
protected:
  // With the pointer on the gland, one step of the wheel after the other until it is felt.
  void PressByWheel() { this->Press(CenterOf(this->Fit().Model), 0.6); }
  // 1.4 mm below the point where the line to the eye leaves the gland.
  void HoldInGland()
  {
    const RadialModel& gland = *this->Fit().Radial();
    const Vector3 toEye = this->Window->Views()->Space()->Axes().col(2);
    this->HoldStill(gland.CenterWorld() + (gland.Radius(toEye) - 1.4) * toEye, toEye);
  }

  void OpenAndLook();
  void Judge();
  void Touch();
  void Replay();
  void Keep();
};

void TutorialTest::OpenAndLook()
{
  this->DropFiles({"prostate/volume.nii.gz", "prostate/mask.nii.gz"});
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  this->Settle();
  DrawAll(*this->Window->Views());
  SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  Click(axial->Canvas(),
        {0.5 * axial->Canvas()->width() + 20.0, 0.5 * axial->Canvas()->height() + 12.0});
  EXPECT_EQ(this->Messages(), "");
  this->ExpectBaseline("tutorial-open.png");
}

void TutorialTest::Judge()
{
  EXPECT_EQ(this->Fit().State, FitResult::Outcome::Fitted);
  const double fine = this->Fit().ModelToMask.Mean;
  EXPECT_LT(fine, 0.3); // mm; a tenth of a slice
  auto* degree = this->Window->findChild<QDoubleSpinBox*>("Degree of all");
  degree->setValue(4);
  this->Settle();
  EXPECT_GT(this->Fit().ModelToMask.Mean, fine);
  this->Action("All as error maps")->trigger();
  this->Settle();
  this->ExpectBaseline("tutorial-error.png");
  this->Action("Undo")->trigger();
  this->Action("Undo")->trigger();
  this->Settle();
  EXPECT_EQ(this->Fit().ModelToMask.Mean, fine);
}

void TutorialTest::Touch()
{
  this->Button("start-touch")->click();
  WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
  ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
  this->PressByWheel();
  this->HoldInGland();
  this->Button("add-touched")->click();
  ASSERT_EQ(this->Study->State().Landmarks.size(), 1U);
  this->Raise("Plots");
  this->ExpectBaseline("tutorial-touch.png");
}

// Records the touch and replays it.
void TutorialTest::Replay()
{
  const auto file = QString::fromStdString(this->File("prostate/case.touch").string());
  this->SavedTo = file;
  this->Button("record")->click();
  ASSERT_TRUE(this->Study->Current().Touch().IsRecording()) << this->Messages();
  this->HoldInGland();
  this->Button("record")->click();
  this->Button("start-touch")->click();
  EXPECT_FALSE(this->Study->IsTouching());
  this->Opened = QStringList{file};
  this->Action("Open a recording")->trigger();
  WaitUntil([this] { return this->Study->Current().Replay() != nullptr; });
  auto* slider = this->Window->findChild<QSlider*>("replay-slider");
  slider->setValue(slider->maximum());
  WaitUntil([this] { return this->Window->Contents().Probe()->GetInContact(); });
  this->ExpectBaseline("tutorial-replay.png");
  this->Button("replay-close")->click();
}

void TutorialTest::Keep()
{
  this->SavedTo = QString::fromStdString(this->File("marks.mrk.json").string());
  this->Button("export-landmarks")->click();
  this->FinishWriting();
  EXPECT_TRUE(std::filesystem::exists(this->File("marks.mrk.json"))) << this->Messages();
  this->SavedTo = QString::fromStdString(this->File("prostate/case.palpate.json").string());
  this->Action("Save as")->trigger();
  ASSERT_TRUE(std::filesystem::exists(this->File("prostate/case.palpate.json")));
  const test::CommandRun run = test::RunPalpate(
      {"study", "prostate/case.palpate.json", "--output", "results"}, this->Phantom.Folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(this->File("results/markups.csv")));
}

TEST_F(TutorialTest, TenStepsLeadToTouchedProstate)
{
  const test::CommandRun run =
      test::RunPalpate({"phantom", "--output", "prostate"}, this->Phantom.Folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  ASSERT_NO_FATAL_FAILURE(this->OpenAndLook());
  ASSERT_NO_FATAL_FAILURE(this->Judge());
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  ASSERT_NO_FATAL_FAILURE(this->Replay());
  ASSERT_NO_FATAL_FAILURE(this->Keep());
}
} // namespace
} // namespace palpate::tutorial_test
