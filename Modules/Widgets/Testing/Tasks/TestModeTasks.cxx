#include "MaskTruth.h"
#include "SceneFile.h"
#include "TaskWindow.h"

#include <QLabel>

#include <cmath>

namespace palpate::mode_tasks_test
{
namespace
{
using test::BallRadius;

// Tasks that are done in modes of the window: a mask that is pushed and pulled, a body that is
// held.
class ModeTasksTest : public test::TaskWindow
{
protected:
  void WriteMaskTask(bool hasForce = true)
  {
    TaskSettings task = OneTrial(TaskKind::Mask, hasForce);
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = test::WriteWrongMask(this->Files);
      target.Mask = this->Files / "true.nii.gz";
      target.Image = this->Files / "true.nii.gz";
    }
    this->Write(task);
  }
  // A ball, and where it is to be.
  static Vector3 Way() { return {6.0, -5.0, 0.0}; }
  void WriteDockTask(bool hasForce)
  {
    TaskSettings task = OneTrial(TaskKind::Dock, hasForce);
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = test::WriteTwoBalls(this->Files, Way());
      target.Points = {{"", Vector3::Zero()}};
      target.Pose = {Way(), Vector3::Zero()};
    }
    this->Write(task);
  }
  void Start(const QSize& size = test::TaskSizes[0])
  {
    this->Window->resize(size);
    this->Begin();
    this->StartTrial();
    EXPECT_EQ(this->Window->size(), size);
    this->Window->Contents().Crosshair()->SetPositionWorld(Vector3::Zero().eval().data());
    DrawAll(*this->Window->Views());
  }
  SlicePane* Axial() const { return this->Window->Views()->Slice(SliceOrientation::Axial); }
  void Drag(const Vector3& from, const Vector3& to, bool isReleased = true,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QWidget* canvas = this->Axial()->Canvas();
    const auto at = [&](double part) { return PlaceIn(*this->Axial(), from + part * (to - from)); };
    SendMouse(canvas, QEvent::MouseMove, at(0.0), Qt::NoButton, Qt::NoButton, modifiers);
    SendMouse(canvas, QEvent::MouseButtonPress, at(0.0), Qt::LeftButton, Qt::LeftButton, modifiers);
    for (int n = 1; n <= 10; ++n)
    {
      SendMouse(canvas, QEvent::MouseMove, at(0.1 * n), Qt::NoButton, Qt::LeftButton, modifiers);
    }
    if (isReleased)
    {
      SendMouse(canvas, QEvent::MouseButtonRelease, at(1.0), Qt::LeftButton, Qt::NoButton,
                modifiers);
    }
  }
  const std::vector<CorrectionStep>& Steps() const { return this->Study->State().Correction.Steps; }
  // Dice and mean distance of the mask after these steps.
  BodyComparison Compared(const std::vector<CorrectionStep>& steps) const
  {
    const TaskTarget target = ReadTask(this->TaskFile()).Targets.front();
    const SceneSettings scene = ReadScene(target.Scene);
    CorrectedShape shape = ReadWrongMask(target, scene);
    shape.Do(steps);
    return shape.CompareWith(ReadTrueMask(target, scene));
  }
  const HeldOrgan& Organ() const { return this->Window->findChild<MatchingLink*>()->Organ(); }
  double Result(TaskKind kind, const char* measure)
  {
    return ValueOf(ReadTaskResults(this->Results()).Rows.at(0), kind, measure);
  }
  // The hand to a place of the world, and until it is there.
  void LeadTo(const Vector3& place)
  {
    this->FeelUntil(
        [&]
        {
          this->Study->Current().Touch().MoveHand(place);
          return (this->Probe() - place).norm() < 2.0;
        });
  }
  // Once the table is written, which then is removed.
  void Leave()
  {
    WaitUntil([this] { return this->Button("task-open-folder")->isVisible(); });
    ClickOn(this->Button("task-page-stop"));
    std::filesystem::remove_all(this->Results());
  }
  void PressSpace()
  {
    Activate(*this->Window);
    QTest::keyClick(this->Axial()->Canvas(), Qt::Key_Space);
  }
};

TEST_F(ModeTasksTest, PulledMaskIsScoredAgainstTheTrueOneAtUsualSizes)
{
  for (const QSize& size : test::TaskSizes)
  {
    this->WriteMaskTask();
    this->Start(size);
    ASSERT_TRUE(this->Action("Push and pull")->isChecked());
    EXPECT_FALSE(this->Button("task-undo")->isEnabled());
    this->Drag({0.0, 6.5, 0.0}, {0.0, 11.5, 0.0});
    ASSERT_EQ(this->Steps().size(), 1U);
    WaitUntil([this] { return this->Button("task-undo")->isEnabled(); });
    this->Drag({-12.0, 0.0, 0.0}, {-16.0, 0.0, 0.0}); // is taken back
    ASSERT_EQ(this->Steps().size(), 2U);
    ClickOn(this->Button("task-undo"));
    const std::vector<CorrectionStep> steps = this->Steps();
    ASSERT_EQ(steps.size(), 1U);
    this->Show(QString("task-mask-%1").arg(size.width()));
    this->EndTrial();
    EXPECT_FALSE(this->Action("Push and pull")->isChecked());
    const BodyComparison after = this->Compared(steps);
    const BodyComparison before = this->Compared({});
    EXPECT_EQ(this->Result(TaskKind::Mask, "dice"), after.Overlap->Dice());
    EXPECT_EQ(this->Result(TaskKind::Mask, "distance_mean_mm"), after.Both.Mean);
    EXPECT_LT(after.Both.Mean, 0.8 * before.Both.Mean) << "better than it was";
    EXPECT_NE(this->LastResult().find(R"("ended_by":"done")"), std::string::npos);
    this->Leave();
  }
}

TEST_F(ModeTasksTest, ToolGripsTheMaskThatItTouches)
{
  this->WriteMaskTask();
  this->Start();
  this->FeelUntil(
      [this]
      {
        this->Study->Current().Touch().MoveHand({0.0, 7.5, 0.0});
        return this->Study->Reading().TouchedId == 1;
      });
  this->PressSpace();
  this->LeadTo(this->Probe() + Vector3(0.0, 4.0, 0.0));
  this->PressSpace();
  ASSERT_EQ(this->Steps().size(), 1U) << this->Messages();
  this->EndTrial();
  EXPECT_GT(this->Result(TaskKind::Mask, "dice"), this->Compared({}).Overlap->Dice());
}

TEST_F(ModeTasksTest, MaskAsItWasIsGivenUpAndStillMeasured)
{
  this->WriteMaskTask(false);
  this->Start();
  this->EndTrial();
  EXPECT_NE(this->LastResult().find(R"("ended_by":"given-up")"), std::string::npos);
  EXPECT_EQ(this->Result(TaskKind::Mask, "dice"), this->Compared({}).Overlap->Dice());
}

TEST_F(ModeTasksTest, InterruptedMaskBeginsAgainFromItsStart)
{
  this->WriteMaskTask();
  this->Start();
  this->Drag({0.0, 6.5, 0.0}, {0.0, 11.5, 0.0});
  ASSERT_EQ(this->Steps().size(), 1U);
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  ASSERT_TRUE(this->Link()->IsResting());
  EXPECT_FALSE(this->Action("Push and pull")->isChecked());
  this->StartTrial();
  EXPECT_TRUE(this->Steps().empty());
  EXPECT_TRUE(this->Action("Push and pull")->isChecked());
  this->Drag({0.0, 6.5, 0.0}, {0.0, 11.5, 0.0});
  this->KillAndStartAgain();
  this->Begin();
  this->StartTrial();
  EXPECT_TRUE(this->Steps().empty());
  this->EndTrial();
  EXPECT_NE(this->LastResult().find(R"("attempt":3)"), std::string::npos) << this->LastResult();
}

TEST_F(ModeTasksTest, TrueMaskWithoutTheLabelStopsATrialBeforeItBegins)
{
  this->WriteMaskTask();
  test::LabelGrid grid;
  grid.Size = {{8, 8, 8}};
  WriteImage(this->Files / "true.nii.gz",
             test::MakeLabelImage(
                 grid, [](double, double, double) { return true; }, 7));
  this->Begin();
  WaitUntil([this] { return !this->Text("task-page-state").isEmpty(); });
  EXPECT_TRUE(this->Text("task-page-state").contains("label"))
      << this->Text("task-page-state").toStdString();
  EXPECT_FALSE(this->Button("task-start")->isEnabled());
}

TEST_F(ModeTasksTest, DraggedBodyStaysWhereItIsLetGoAtUsualSizes)
{
  for (const QSize& size : test::TaskSizes)
  {
    this->WriteDockTask(false);
    this->Start(size);
    ASSERT_TRUE(this->Action("Hold and match")->isChecked());
    EXPECT_FALSE(this->Button("task-back")->isEnabled());
    const Vector3 end = Way() + Vector3(1.0, 0.0, 0.0);
    this->Drag(Vector3::Zero(), end);
    EXPECT_EQ(this->Organ().Is(), HeldOrgan::Phase::Lying) << "no match";
    EXPECT_FALSE(this->Organ().Match());
    this->Show(QString("task-dock-%1").arg(size.width()));
    this->EndTrial();
    EXPECT_EQ(this->Organ().Is(), HeldOrgan::Phase::Absent);
    // Without force nothing keeps the body from where the pointer is, to a pixel.
    EXPECT_NEAR(this->Result(TaskKind::Dock, "shift_error_mm"), 1.0, 0.3);
    EXPECT_LT(this->Result(TaskKind::Dock, "turn_error_degrees"), 1e-6);
    this->Leave();
  }
}

TEST_F(ModeTasksTest, TurnedBodyHasTheAngleAsItsError)
{
  this->WriteDockTask(false);
  this->Start();
  this->Drag({15.0, 0.0, 0.0}, {15.0, 5.0, 0.0}, true, Qt::ControlModifier);
  this->EndTrial();
  const double angle = std::atan2(5.0, 15.0) * 180.0 / M_PI;
  EXPECT_NEAR(this->Result(TaskKind::Dock, "turn_error_degrees"), angle, 1.0); // a pixel
  EXPECT_NEAR(this->Result(TaskKind::Dock, "shift_error_mm"), Way().norm(), 0.3);
}

TEST_F(ModeTasksTest, ToolHoldsABodyWithForceAndNothingSnaps)
{
  this->WriteDockTask(true);
  this->Start();
  this->LeadTo({0.0, 0.0, 30.0});
  this->PressSpace();
  ASSERT_EQ(this->Organ().Is(), HeldOrgan::Phase::Carried) << this->Messages();
  const Vector3 start = this->Probe();
  this->FeelUntil(
      [&]
      {
        this->Study->Current().Touch().MoveHand(start + Way() + Vector3(0.0, 3.0, 0.0));
        return (this->Probe() - start).norm() > 0.8 * Way().norm() &&
               test::Norm(this->Study->Reading().Newest.ForceWorld) > 0.3;
      });
  this->PressSpace();
  EXPECT_EQ(this->Organ().Is(), HeldOrgan::Phase::Lying);
  EXPECT_FALSE(this->Organ().Match());
  const Vector3 moved = this->Organ().Middle();
  this->EndTrial();
  EXPECT_GT(TaskResults(ReadTaskResults(this->Results())).Rows.at(0).End.Conduct.PeakForce, 0.3);
  EXPECT_LT(this->Result(TaskKind::Dock, "shift_error_mm"), Way().norm());
  EXPECT_GT(moved.norm(), 1.0);
}

TEST_F(ModeTasksTest, EscapeLetsABodyGoWithoutAMatchAndTheTrialBeginsAgain)
{
  this->WriteDockTask(true);
  this->Start();
  this->Drag(Vector3::Zero(), Way(), false);
  ASSERT_EQ(this->Organ().Is(), HeldOrgan::Phase::Pointed);
  bool wasMatching = false;
  const auto link = QObject::connect(
      this->Window->findChild<MatchingLink*>(), &MatchingLink::Changed,
      [&] { wasMatching = wasMatching || this->Organ().Is() == HeldOrgan::Phase::Matching; });
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  QObject::disconnect(link);
  EXPECT_FALSE(wasMatching);
  ASSERT_TRUE(this->Link()->IsResting());
  this->StartTrial();
  EXPECT_TRUE(this->Organ().Pose().isApprox(Eigen::Affine3d::Identity()));
  EXPECT_TRUE(this->Action("Hold and match")->isChecked());
  ClickOn(this->Button("task-stop"));
  EXPECT_TRUE(this->Window->findChild<MatchingLink*>()->Rules().IsMatched) << "as before";
}

TEST_F(ModeTasksTest, ReadyTasksOfBothKindsOpen)
{
  for (const char* title : {"Correct a mask", "Dock two bodies"})
  {
    this->Chosen = QString::fromStdString((this->Files / title).string());
    this->Action(title)->trigger();
    WaitUntil([this] { return this->Form() != nullptr; });
    ClickOn(this->Form()->findChild<QPushButton*>("task-begin"));
    this->StartTrial();
    this->Show(QString("task-ready-") + title);
    ClickOn(this->Button("task-stop"));
  }
}
} // namespace
} // namespace palpate::mode_tasks_test
