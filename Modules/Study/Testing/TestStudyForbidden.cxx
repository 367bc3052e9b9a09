#include "StudyForbidden.h"

#include "DrillContextCases.h"
#include "DrillState.h"
#include "ForbiddenPhantom.h"
#include "ManualClock.h"
#include "PlacedDevice.h"
#include "RandomShapes.h"
#include "Study.h"
#include "StudyFiles.h"
#include "WholeFile.h"

#include <gtest/gtest.h>
#include <thread>

namespace palpate::study_forbidden_test
{
namespace
{
using test::ForbiddenPhantom;
using Kind = StudyStepState::Kind;

// The servo runs as fast as it can, in virtual time; with real-time priority it would block
// everything else.
RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

class StudyForbiddenTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Open.OpenSegmentation(this->Phantom.File);
    this->Settle();
    ASSERT_EQ(this->Open.State().Structures.size(), 12U);
  }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  void Change(const StudyState& next) { this->Open.Change("step", next); }
  void StartTouch()
  {
    this->Open.StartTouch();
    this->Settle();
    ASSERT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
  }
  // Drilled bone during a touch, without forbidden structures.
  void StartDrilling()
  {
    this->Change(ForbiddenPhantom::Drilled(this->Open.State()));
    this->Settle();
    this->StartTouch();
  }
  template <typename Condition>
  const StudyTouchReading& WaitUntil(const Condition& holds)
  {
    while (!holds(this->Open.Touch().Poll()))
    {
      std::this_thread::yield();
    }
    return this->Open.Touch().Poll();
  }
  void PlaceOutside()
  {
    constexpr double Outside = ForbiddenPhantom::BoneRadius + 4.0; // the burr's radius is 3 mm
    this->Open.Touch().MoveHand(Vector3(Outside + 1.0, 0.0, 0.0));
    this->WaitUntil([&](const StudyTouchReading& now)
                    { return now.Newest.ProbeWorld.X > Outside; });
  }
  // Moves from outside along x to a place before the bone's centre, with the pedal down; returns
  // the reading after this much servo time (s).
  const StudyTouchReading& PressWithPedal(double x, double seconds)
  {
    this->PlaceOutside();
    this->Open.Touch().MoveHand(Vector3(x, 0.0, 0.0));
    this->Open.Touch().RunDrill(true);
    return this->Pass(seconds);
  }
  // The reading after this much servo time (s).
  const StudyTouchReading& Pass(double seconds)
  {
    const std::int64_t end = this->Time.Now() + static_cast<std::int64_t>(1e9 * seconds);
    return this->WaitUntil([&](const StudyTouchReading& now)
                           { return now.Newest.Tick.Started > end; });
  }
  double Removed() { return this->Open.Touch().Poll().Drill.Drilled.at(0).RemovedVolume; }
  std::string Hold() { return this->Open.Touch().Poll().Drill.Hold; }
  StudyStepState Protection(int label = ForbiddenPhantom::Nerve)
  {
    return this->Open.Pipeline().StateOf(SceneStep::Protection, label);
  }

  ForbiddenPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time, Ordinary()};
};

TEST_F(StudyForbiddenTest, ProtectsThoughNeitherVisibleNorTouchable)
{
  const SceneStructure& nerve = this->Open.State().Structures.back();
  ASSERT_EQ(nerve.Id, ForbiddenPhantom::Nerve);
  ASSERT_FALSE(nerve.IsVisible || nerve.IsTouchable);
  this->Change(ForbiddenPhantom::Forbidden(ForbiddenPhantom::Drilled(this->Open.State())));
  this->Settle();
  ASSERT_EQ(this->Protection().Is, Kind::UpToDate) << this->Protection().Message;
  this->StartTouch();
  this->PressWithPedal(0.0, 8.0);
  const StudyDrillReading& drill =
      this->WaitUntil(
              [](const StudyTouchReading& now)
              { return !now.Drill.Approaches.empty() && now.Drill.Approaches[0].IsAlarmed; })
          .Drill;
  EXPECT_EQ(drill.Approaches[0].Name, "label 12");
  EXPECT_EQ(drill.Hold, "");
  // The burr reached the nerve without cutting it; the nerve's surface is accurate to a fraction of
  // a 1 mm voxel.
  this->WaitUntil([](const StudyTouchReading& now) { return now.Drill.Approaches[0].Least < 0.0; });
  this->Open.Touch().RunDrill(false);
  const vtkSmartPointer<vtkPolyData> cut =
      this->WaitUntil([](const StudyTouchReading& now) { return !now.Newest.IsDrilling; })
          .Drill.Drilled.at(0)
          .Cut;
  ASSERT_GT(cut->GetNumberOfPoints(), 100);
  double nearest = ForbiddenPhantom::BoneRadius;
  for (vtkIdType n = 0; n < cut->GetNumberOfPoints(); ++n)
  {
    nearest = std::min(nearest, Vector3(cut->GetPoint(n)).norm());
  }
  EXPECT_GT(nearest, ForbiddenPhantom::NerveRadius - 0.6);
}

TEST_F(StudyForbiddenTest, CutsNothingBeforeTheProtectionIsReady)
{
  this->StartDrilling();
  ASSERT_EQ(this->Hold(), "");
  // The worker's result is delivered only by Settle.
  this->Change(ForbiddenPhantom::Forbidden(this->Open.State()));
  ASSERT_EQ(this->Hold(), "Drilling waits for the protection of label 12.");
  const StudyTouchReading& held = this->PressWithPedal(6.0, 2.0);
  EXPECT_TRUE(held.Newest.IsDrilling);
  EXPECT_GT(held.Newest.Depth, 0.5) << "the tool is in contact";
  EXPECT_EQ(held.Newest.DrillOrders, 0U);
  EXPECT_EQ(this->Removed(), 0.0);
  this->Settle();
  EXPECT_EQ(this->Hold(), "");
  // The pedal that was down throughout does not start to cut without a new press.
  EXPECT_FALSE(this->WaitUntil([](const StudyTouchReading& now) { return !now.Newest.IsDrilling; })
                   .Newest.IsDrilling);
  EXPECT_EQ(this->Removed(), 0.0);
  this->Open.Touch().RunDrill(true);
  this->WaitUntil([this](const StudyTouchReading&) { return this->Removed() > 1.0; });
}

TEST_F(StudyForbiddenTest, HeldButtonDoesNotStartToCut)
{
  constexpr unsigned Button = 1U << StudyTouch::DrillButton;
  this->Change(ForbiddenPhantom::Drilled(this->Open.State()));
  this->Settle();
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  const StudyState& state = this->Open.State();
  ASSERT_TRUE(this->Open.Touch().Start(std::move(owned), state, this->Open.Contacts()).IsOk());
  // The worker's result is delivered only by Settle.
  this->Change(ForbiddenPhantom::Forbidden(this->Open.State()));
  ASSERT_NE(this->Hold(), "");
  const Vector3 pressed = this->Open.Touch().Frame().ToDevice({6.0, 0.0, 0.0});
  for (double path = 0.0; path < 1.0; path += 0.01)
  {
    device->Put(path * pressed, 0);
    this->Pass(0.001);
  }
  device->Put(pressed, Button);
  this->WaitUntil([](const StudyTouchReading& now) { return now.Newest.IsDrilling; });
  this->Settle();
  ASSERT_EQ(this->Hold(), "");
  this->Pass(1.0);
  EXPECT_EQ(this->Removed(), 0.0);
  device->Put(pressed, 0);
  this->Pass(0.01);
  device->Put(pressed, Button);
  this->WaitUntil([this](const StudyTouchReading&) { return this->Removed() > 1.0; });
}

TEST_F(StudyForbiddenTest, KeepsRemovedMaterialWhileAProtectionIsMade)
{
  this->StartDrilling();
  this->PlaceOutside();
  this->Open.Touch().MoveHand(Vector3(6.0, 0.0, 0.0));
  this->Open.Touch().RunDrill(true);
  this->WaitUntil([this](const StudyTouchReading&) { return this->Removed() > 20.0; });
  this->Change(ForbiddenPhantom::Forbidden(this->Open.State()));
  EXPECT_GT(this->Removed(), 19.0);
  this->Settle();
  EXPECT_GT(this->Removed(), 19.0);
}

TEST_F(StudyForbiddenTest, FailedProtectionTurnsTheDrillOffWithReason)
{
  this->StartDrilling();
  StudyState next = this->Open.State();
  next.Structures.push_back(
      test::StudyPhantom::Structure(77, TouchRepresentation::Automatic,
                                    next.SegmentationFile)); // not in any voxel
  next.Structures.back().Name = "Pallidum_L";
  next.Structures.back().IsTouchable = false;
  next.Structures.back().IsVisible = false;
  next.Structures.back().IsForbidden = true;
  this->Change(next);
  this->Settle();
  EXPECT_EQ(this->Protection(77).Is, Kind::Failed);
  const std::string hold = this->Hold();
  EXPECT_EQ(hold.rfind("Drilling is off, because Pallidum_L cannot be protected: ", 0), 0U) << hold;
  EXPECT_NE(hold.find("77"), std::string::npos) << hold;
  EXPECT_NE(hold.find("another drill role"), std::string::npos) << hold;
  EXPECT_EQ(this->PressWithPedal(6.0, 2.0).Newest.DrillOrders, 0U);
  next.Structures.back().IsForbidden = false;
  this->Change(next);
  EXPECT_EQ(this->Hold(), "");
}

TEST_F(StudyForbiddenTest, CancelledProtectionTurnsTheDrillOffUntilResumed)
{
  this->StartDrilling();
  this->Change(ForbiddenPhantom::Forbidden(this->Open.State()));
  this->Open.CancelStep(SceneStep::Protection);
  this->Settle();
  EXPECT_TRUE(this->Protection().IsCancelled);
  EXPECT_NE(this->Hold().find("the protection of label 12 was cancelled"), std::string::npos)
      << this->Hold();
  EXPECT_EQ(this->PressWithPedal(6.0, 2.0).Newest.DrillOrders, 0U);
  this->Open.ResumeStep(SceneStep::Protection);
  EXPECT_EQ(this->Hold(), "Drilling waits for the protection of label 12.");
  this->Settle();
  EXPECT_EQ(this->Hold(), "");
}

// If the new scene cannot be touched, the previous one stays, which lacks the protection.
TEST_F(StudyForbiddenTest, CutsNothingIfTheProtectedSceneCannotBeTouched)
{
  this->StartDrilling();
  StudyState next = ForbiddenPhantom::Forbidden(this->Open.State());
  next.Tool.Radius = -1.0;
  this->Change(next);
  EXPECT_NE(this->Open.TouchProblem(), "");
  EXPECT_EQ(this->PressWithPedal(6.0, 2.0).Newest.DrillOrders, 0U);
  next.Tool.Radius = 3.0;
  this->Change(next);
  this->Settle();
  this->Open.Touch().RunDrill(true);
  this->WaitUntil([this](const StudyTouchReading&) { return this->Removed() > 1.0; });
}

TEST_F(StudyForbiddenTest, RowShowsTheStateOfTheProtection)
{
  const auto row = [this]
  { return ProtectionText(ForbiddenOf(this->Open.State(), this->Open.Pipeline()).at(0)); };
  this->Change(ForbiddenPhantom::Forbidden(ForbiddenPhantom::Drilled(this->Open.State())));
  EXPECT_EQ(row(), "Protection waits");
  this->Open.CancelStep(SceneStep::Protection);
  EXPECT_EQ(row(), "Protection cancelled");
  this->Open.ResumeStep(SceneStep::Protection);
  this->Settle();
  EXPECT_EQ(row(), "Protected");
}

TEST(DrillHoldText, NamesOneAndCountsTheOthers)
{
  const auto waiting = [](const std::string& name) {
    return StudyForbidden{{name, 2.0, nullptr}, 1, {Kind::Running, 0.5, {}, {}}};
  };
  EXPECT_EQ(DrillHoldText({}), "");
  EXPECT_EQ(DrillHoldText({waiting("a")}), "Drilling waits for the protection of a.");
  EXPECT_EQ(DrillHoldText({waiting("a"), waiting("b"), waiting("c")}),
            "Drilling waits for the protection of a and 2 more.");
}

// Between random places in the bone.
std::vector<std::pair<Vector3, Vector3>> RandomSweeps()
{
  constexpr int Count = 40;
  test::Random random(17);
  std::vector<std::pair<Vector3, Vector3>> sweeps;
  for (int n = 0; n < Count; ++n)
  {
    const Vector3 from = 9.0 * test::RandomDirection(random);
    sweeps.emplace_back(from, 9.0 * test::RandomDirection(random));
  }
  return sweeps;
}

TEST_F(StudyForbiddenTest, CommandLineProtectsTheSame)
{
  const StudyState state =
      ForbiddenPhantom::Forbidden(ForbiddenPhantom::Drilled(this->Open.State()));
  this->Change(state);
  this->Settle();
  const StudyPipeline& pipeline = this->Open.Pipeline();
  const auto contacts = this->Open.Contacts();
  StudyDrill drill;
  drill.Follow(state, contacts, ForbiddenOf(state, pipeline));
  TouchScene scene = MakeTouchScene(state, contacts, {});
  drill.PutInto(scene);
  CutOrder order;
  order.Site = 0;
  for (const auto& [from, to] : RandomSweeps())
  {
    order.From.PositionWorld = from;
    order.To.PositionWorld = to;
    ASSERT_TRUE(scene.Drill.Link->Orders.Push(order));
    ++order.Number;
  }
  drill.Editor()->Take();
  WriteDrillRecords(this->Phantom.Folder / "window.state", drill.Take().Records);

  const auto context = test::BenchOf(state);
  ASSERT_EQ(context->Forbidden().size(), 1U);
  EXPECT_EQ(context->Forbidden()[0].AlarmDistance, state.Structures.back().AlarmDistance);
  test::ContextCuts cuts(context);
  for (const auto& [from, to] : RandomSweeps())
  {
    cuts.Cut(from, to);
  }
  WriteDrillState(this->Phantom.Folder / "command.state", *context);
  constexpr std::uintmax_t Largest = 1 << 28;
  EXPECT_EQ(ReadWholeFile(this->Phantom.Folder / "window.state", Largest),
            ReadWholeFile(this->Phantom.Folder / "command.state", Largest));
}
} // namespace
} // namespace palpate::study_forbidden_test
