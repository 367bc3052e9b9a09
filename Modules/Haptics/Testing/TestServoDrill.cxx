#include "DrillCases.h"
#include "ServoRun.h"

#include <atomic>
#include <thread>

namespace palpate::servo_drill_test
{
namespace
{
using test::DrilledBlock;

constexpr double Depth = 3.0; // mm that a hand presses below the first contact
const Vector3 Pressed(0.1, -0.2,
                      DrilledBlock::Top + DrilledBlock::Radius - DrilledBlock::Clearance - Depth);
// N; a tracker ends within a fiftieth of a voxel of the surface, a drilled one within a tenth.
constexpr double Close = DrilledBlock::Stiffness * 0.1 * DrilledBlock::Spacing;

// Approaches from above, and stays until all fading has ended. Returns the force, N.
Vector3 Press(test::ServoRun& run)
{
  for (double height = 4.0; height > 0.0; height -= 0.01)
  {
    run.TickAt(Pressed + height * Vector3::UnitZ());
  }
  return run.RestAt(Pressed);
}

// With versions at every tick.
void DrillFor(int ticks, test::ServoRun& run, DrilledBlock& block)
{
  run.Loop.RunDrill(true);
  for (int n = 0; n < ticks; ++n)
  {
    run.TickAt(Pressed);
    block.Editor->Take();
  }
}

TEST(ServoDrill, DrillSinksByPushAndSpeed)
{
  for (const int late : {1, 3, 10})
  {
    DrilledBlock block;
    test::ServoRun run(block.Scene());
    const double first = Press(run).norm();
    EXPECT_NEAR(first, DrilledBlock::Stiffness * Depth, Close);
    run.Loop.RunDrill(true);
    double wanted = first;
    for (int n = 0; n < 600; ++n)
    {
      const double force = run.TickAt(Pressed).norm();
      ASSERT_NEAR(force, wanted, Close) << "tick " << n << ", versions every " << late;
      wanted *= 1.0 - 1e-3 * DrilledBlock::FeedConstant();
      if (n % late == 0)
      {
        block.Editor->Take();
      }
    }
    EXPECT_LT(wanted, 0.2 * first);
    EXPECT_TRUE(run.Loop.Latest().IsDrilling);
    EXPECT_GT(run.Loop.Latest().DrillVersion, 100u);
  }
}

// Each version shows the cuts of many ticks at once, without a change of force.
TEST(ServoDrill, ForceIsSmoothAcrossVersions)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Vector3 last = Press(run);
  run.Loop.RunDrill(true);
  const double sinking = 1e-3 * DrilledBlock::FeedConstant() * last.norm();
  for (int n = 0; n < 300; ++n)
  {
    const Vector3 force = run.TickAt(Pressed);
    // A version's surface lies within a twentieth of a voxel of the cut.
    ASSERT_LE((force - last).norm(), sinking + 0.5 * Close) << n;
    last = force;
    if (n % 20 == 19)
    {
      block.Editor->Take();
    }
  }
}

TEST(ServoDrill, RemovesTheSweptVolume)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  DrillFor(3000, run, block);
  run.Loop.RunDrill(false);
  EXPECT_LT(run.TickAt(Pressed).norm(), Close);
  block.Editor->Take();
  // A hemisphere and a cylinder above it, down to where the smaller tool is at the probe.
  constexpr double R = DrilledBlock::Radius;
  constexpr double Deep = Depth + DrilledBlock::Clearance;
  const double wanted = M_PI * R * R * (2.0 / 3.0 * R + (Deep - R));
  EXPECT_NEAR(block.Editor->RemovedVolumes()[0], wanted, 0.01 * wanted);
}

TEST(ServoDrill, BallOnAShaftSinksAsASphereDoes)
{
  DrilledBlock block;
  TouchScene scene = block.Scene();
  constexpr double R = DrilledBlock::Radius;
  scene.Tool = ToolShape::Drill(R - DrilledBlock::Clearance, 0.8, 30.0, 200);
  test::ServoRun run(scene);
  EXPECT_NEAR(Press(run).norm(), DrilledBlock::Stiffness * Depth, Close);
  DrillFor(3000, run, block);
  run.Loop.RunDrill(false);
  EXPECT_LT(run.TickAt(Pressed).norm(), Close);
  block.Editor->Take();
  constexpr double Deep = Depth + DrilledBlock::Clearance;
  const double wanted = M_PI * R * R * (2.0 / 3.0 * R + (Deep - R));
  // A foot on a field is within a twentieth of a voxel, by which the hole may be wider.
  EXPECT_NEAR(block.Editor->RemovedVolumes()[0], wanted, 0.04 * wanted);
}

TEST(ServoDrill, ShaftTouchesButCutsNothing)
{
  DrilledBlock block;
  TouchScene scene = block.Scene();
  constexpr double Length = 30.0;
  constexpr double Shaft = 0.8;
  scene.Tool = ToolShape::Drill(DrilledBlock::Radius - DrilledBlock::Clearance, Shaft, Length, 200);
  test::ServoRun run(scene);
  run.Device.Next.Orientation = {1.0, 0.0, 0.0, 0.0}; // upside down
  const Vector3 pressed(0.1, -0.2, DrilledBlock::Top + Length + Shaft - Depth);
  const Vector3 force = run.MoveAndRest(pressed + 10.0 * Vector3::UnitZ(), pressed);
  EXPECT_NEAR(force.norm(), DrilledBlock::Stiffness * Depth, Close);
  run.Loop.RunDrill(true);
  for (int n = 0; n < 500; ++n)
  {
    // A tool that were fed would sink until a version shows that nothing was cut.
    ASSERT_NEAR(run.TickAt(pressed).norm(), force.norm(), Close) << n;
    if (n % 100 == 99)
    {
      block.Editor->Take();
    }
  }
  EXPECT_EQ(block.Editor->RemovedVolumes()[0], 0.0);
}

// Each pass slightly deeper, until nothing is left between the hand and its goal.
TEST(ServoDrill, MovingToAndFroMillsAGroove)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene(2.0));
  const Vector3 middle(0.0, 0.0, DrilledBlock::Top + DrilledBlock::Radius - 1.0);
  const auto hand = [&](int n) { return middle + 4.0 * std::sin(0.005 * n) * Vector3::UnitX(); };
  for (double height = 3.0; height > 0.0; height -= 0.01)
  {
    run.TickAt(middle + height * Vector3::UnitZ());
  }
  run.Loop.RunDrill(true);
  double most = 0.0;
  for (int n = 0; n < 20000; ++n)
  {
    const Vector3 force = run.TickAt(hand(n)); // at 20 mm/s at the centre
    most = n < 19000 ? 0.0 : std::max(most, force[2]);
    block.Editor->Take();
  }
  EXPECT_LT(most, 0.2 * DrilledBlock::Stiffness * 1.0);
  // Half of a capsule, and its sides; as deep as the remaining force allows.
  constexpr double R = DrilledBlock::Radius;
  const double deepest = block.Editor->RemovedVolumes()[0];
  const double cap = R * R * std::acos(1.0 - 1.0 / R) - (R - 1.0) * std::sqrt(2.0 * R - 1.0);
  const double ends = M_PI / 3.0 * (3.0 * R - 1.0); // two halves of a spherical cap of 1 mm
  EXPECT_NEAR(deepest, 8.0 * cap + ends, 0.1 * (8.0 * cap + ends));
}

TEST(ServoDrill, CutsNothingWithoutPedalWearOrContact)
{
  const struct
  {
    bool isDown;
    double wear;
    Vector3 place;
  } cases[] = {{false, 0.5, Pressed}, {true, 0.0, Pressed}, {true, 0.5, {0.0, 0.0, 9.0}}};
  for (const auto& one : cases)
  {
    DrilledBlock block;
    test::ServoRun run(block.Scene(one.wear));
    run.Loop.RunDrill(one.isDown);
    for (double height = 4.0; height > 0.0; height -= 0.01)
    {
      run.TickAt(one.place + height * Vector3::UnitZ());
    }
    EXPECT_FALSE(block.Editor->Take());
    EXPECT_EQ(run.Loop.Latest().DrillOrders, 0u);
    EXPECT_EQ(block.Editor->RemovedVolumes()[0], 0.0);
  }
}

TEST(ServoDrill, HangingEditorStopsTheDrillNotTheTouch)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  run.Loop.RunDrill(true);
  const Vector3 stalled = run.RestAt(Pressed);
  EXPECT_EQ(run.Loop.Latest().DrillOrders, DrillFeed::MostWaiting);
  EXPECT_EQ(run.RestAt(Pressed), stalled);
  EXPECT_GT(stalled.norm(), 0.2);
  block.Editor->Take();
  EXPECT_LT(run.RestAt(Pressed).norm(), stalled.norm());
}

TEST(ServoDrill, FaultEndsForceAndCutsAndReleasesThePedal)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  run.Loop.RunDrill(true);
  run.RestAt(Pressed);
  const std::uint64_t orders = run.Loop.Latest().DrillOrders;
  EXPECT_EQ(run.TickAt({test::NotANumber, 0.0, 0.0}), Vector3::Zero());
  EXPECT_EQ(run.Loop.Latest().DrillOrders, orders);
  for (int n = 0; n < 100; ++n)
  {
    ASSERT_EQ(run.TickAt(Pressed), Vector3::Zero());
    block.Editor->Take();
  }
  EXPECT_FALSE(run.Loop.Latest().IsDrilling);
  run.Loop.Rearm();
  run.RestAt(Pressed);
  EXPECT_EQ(run.Loop.Latest().DrillOrders, orders + 1); // the stroke's end
}

constexpr std::uint32_t Button = 2; // the device's second

ServoSettings WithButton()
{
  ServoSettings settings;
  settings.PedalButtons = Button;
  return settings;
}

TEST(ServoDrill, ButtonDrillsInTheSameTick)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene(), WithButton());
  Press(run);
  for (const std::uint32_t buttons : {Button, 5U, Button | 1U, 0U})
  {
    run.Device.Next.Buttons = buttons;
    run.TickAt(Pressed);
    EXPECT_EQ(run.Loop.Latest().IsDrilling, (buttons & Button) != 0) << buttons;
  }
  EXPECT_EQ(run.Loop.Latest().Command, DrillCommand::EndStroke);
}

TEST(ServoDrill, ButtonOrPedalSuffices)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene(), WithButton());
  Press(run);
  run.Device.Next.Buttons = Button;
  run.Loop.RunDrill(true);
  run.TickAt(Pressed);
  run.Device.Next.Buttons = 0;
  run.TickAt(Pressed);
  EXPECT_TRUE(run.Loop.Latest().IsDrilling);
  run.Device.Next.Buttons = Button;
  run.Loop.RunDrill(false);
  run.TickAt(Pressed);
  EXPECT_TRUE(run.Loop.Latest().IsDrilling);
  run.Device.Next.Buttons = 0;
  run.TickAt(Pressed);
  EXPECT_FALSE(run.Loop.Latest().IsDrilling);
}

TEST(ServoDrill, HeldButtonMustBeReleasedAfterStartOrFault)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene(), WithButton());
  run.Device.Next.Buttons = Button;
  Press(run);
  EXPECT_FALSE(run.Loop.Latest().IsDrilling);
  const auto pressAgain = [&run]
  {
    run.Device.Next.Buttons = 0;
    run.TickAt(Pressed);
    run.Device.Next.Buttons = Button;
    run.TickAt(Pressed);
  };
  pressAgain();
  EXPECT_TRUE(run.Loop.Latest().IsDrilling);
  run.Loop.SwitchOff();
  run.RestAt(Pressed);
  EXPECT_FALSE(run.Loop.Latest().IsDrilling);
  run.Loop.Rearm();
  run.RestAt(Pressed);
  EXPECT_FALSE(run.Loop.Latest().IsDrilling);
  pressAgain();
  EXPECT_TRUE(run.Loop.Latest().IsDrilling);
}

TEST(ServoDrill, LiftedPedalsMustBePressedAgain)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene(), WithButton());
  Press(run);
  run.Device.Next.Buttons = Button;
  run.Loop.RunDrill(true);
  run.TickAt(Pressed);
  ASSERT_TRUE(run.Loop.Latest().IsDrilling);
  run.Loop.LiftPedals();
  for (int n = 0; n < 10; ++n)
  {
    run.TickAt(Pressed);
    ASSERT_FALSE(run.Loop.Latest().IsDrilling) << n;
  }
  run.Device.Next.Buttons = 0;
  run.TickAt(Pressed);
  run.Device.Next.Buttons = Button;
  run.TickAt(Pressed);
  EXPECT_TRUE(run.Loop.Latest().IsDrilling);
}

// Both within a tick.
TEST(ServoDrill, PedalPressedAfterTheLiftDrills)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  run.Loop.LiftPedals();
  run.Loop.RunDrill(true);
  run.TickAt(Pressed);
  EXPECT_TRUE(run.Loop.Latest().IsDrilling);
}

TEST(ServoDrill, NoButtonDrillsWithoutPedalButtons)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  run.Device.Next.Buttons = ~0U;
  run.TickAt(Pressed);
  EXPECT_FALSE(run.Loop.Latest().IsDrilling);
}

TEST(ServoDrill, ForcesStayWithinTheDevicesLimitForAnyLaw)
{
  DrilledBlock block;
  TouchScene scene = block.Scene(50.0);
  scene.Structures[0].Law = {4.0, 0.02};
  scene.Structures[0].Drill.Drag = 100.0;
  scene.Structures[0].Drill.Vibration = 1.0;
  test::ServoRun run(scene);
  run.Loop.RunDrill(true);
  test::Random random(99);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  Vector3 place(0.0, 0.0, 9.0);
  double most = 0.0;
  for (int n = 0; n < 4000; ++n)
  {
    const Vector3 target(6.0 * part(random), 6.0 * part(random), 4.0 + 6.0 * part(random));
    place += 0.02 * (target - place);
    const Vector3 force = run.TickAt(place);
    ASSERT_TRUE(force.allFinite());
    ASSERT_LE(force.norm(), run.Device.Abilities.MaximumForce * (1.0 + 1e-12));
    most = std::max(most, force.norm());
    block.Editor->Take();
  }
  EXPECT_GT(most, 1.0);
  EXPECT_GT(block.Editor->RemovedVolumes()[0], 10.0);
}

TEST(ServoDrill, MaterialGrowingBackNeverPushesTheHand)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  const Vector3 first = Press(run);
  DrillFor(700, run, block);
  run.Loop.RunDrill(false);
  Vector3 last = run.TickAt(Pressed);
  EXPECT_GT(last.norm(), 0.1);
  ASSERT_TRUE(run.Loop.Command(DrillCommand::Undo));
  for (int n = 0; n < 200; ++n)
  {
    const Vector3 force = run.TickAt(Pressed);
    ASSERT_LE(force.norm(), last.norm() + Close) << n;
    ASSERT_FALSE(run.Loop.Latest().Safety.IsRamping);
    last = force;
    block.Editor->Take();
  }
  EXPECT_EQ(last, Vector3::Zero());
  EXPECT_EQ(block.Editor->RemovedVolumes()[0], 0.0);
  // It is left without a force, and then has its normal force.
  for (double height = 0.0; height < 4.0; height += 0.01)
  {
    ASSERT_EQ(run.TickAt(Pressed + height * Vector3::UnitZ()), Vector3::Zero()) << height;
  }
  EXPECT_NEAR((Press(run) - first).norm(), 0.0, 1e-6);
}

TEST(ServoDrill, MaterialGrowingBackElsewhereCausesNoStep)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  DrillFor(700, run, block);
  run.Loop.RunDrill(false);
  const Vector3 nearby = Pressed + 6.0 * Vector3::UnitX();
  for (double path = 0.0; path < 1.0; path += 0.01)
  {
    run.TickAt(Pressed + 4.0 * path * Vector3::UnitZ());
  }
  for (double path = 0.0; path < 1.0; path += 0.01)
  {
    run.TickAt(Pressed + 4.0 * Vector3::UnitZ() + path * (nearby - Pressed));
  }
  for (double height = 4.0; height > 0.0; height -= 0.01)
  {
    run.TickAt(nearby + height * Vector3::UnitZ());
  }
  const Vector3 before = run.RestAt(nearby);
  EXPECT_GT(before.norm(), 1.0);
  run.Loop.Command(DrillCommand::Undo);
  for (int n = 0; n < 300; ++n)
  {
    ASSERT_LE((run.TickAt(nearby) - before).norm(), 0.1 * Close) << n;
    block.Editor->Take();
  }
}

TEST(ServoDrill, ContinuedSceneKeepsDrilling)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  run.Loop.RunDrill(true);
  Vector3 last = run.TickAt(Pressed);
  for (int n = 0; n < 200; ++n)
  {
    if (n == 100)
    {
      const auto next = std::make_shared<TouchScene>(block.Scene());
      ASSERT_TRUE(run.Loop.Publish(next, SceneEntry::Continuing).IsOk());
    }
    const Vector3 force = run.TickAt(Pressed);
    ASSERT_LE((force - last).norm(), Close + 0.005) << n; // 0.005 N: the sinking
    last = force;
    if (n % 7 == 0)
    {
      block.Editor->Take();
    }
  }
  EXPECT_GT(run.Loop.Latest().DrillOrders, 40u);
}

TEST(ServoDrill, TakesOneCommandPerTickAndPedalReleaseEndsAStroke)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  run.Loop.RunDrill(true);
  run.TickAt(Pressed);
  run.Loop.RunDrill(false);
  run.Loop.Command(DrillCommand::Undo);
  run.Loop.Command(DrillCommand::Redo);
  for (const DrillCommand wanted :
       {DrillCommand::EndStroke, DrillCommand::Undo, DrillCommand::Redo, DrillCommand::None})
  {
    run.TickAt(Pressed);
    EXPECT_EQ(run.Loop.Latest().Command, wanted);
  }
}

TEST(ServoDrill, RejectsScenesThatCannotBeDrilled)
{
  DrilledBlock block;
  const auto isRefused = [](const TouchScene& scene)
  {
    std::unique_ptr<ServoScene> made;
    return !ServoScene::Make(std::make_shared<TouchScene>(scene), 0.003, made).IsOk();
  };
  EXPECT_FALSE(isRefused(block.Scene()));
  TouchScene scene = block.Scene();
  scene.Drill.Link = nullptr;
  EXPECT_TRUE(isRefused(scene));
  scene = block.Scene(-1.0);
  EXPECT_TRUE(isRefused(scene));
  scene = block.Scene(test::NotANumber);
  EXPECT_TRUE(isRefused(scene));
  scene = block.Scene();
  scene.Drill.Motion.Turns = test::Infinite;
  EXPECT_TRUE(isRefused(scene));
  scene = block.Scene();
  scene.Tool = ToolShape::Sphere(0.0);
  scene.Structures[0].Model = std::make_shared<test::WallModel>(0.0);
  EXPECT_TRUE(isRefused(scene));
}

// A servo at full speed, an editor on a thread, and a reader: the final state follows from the
// orders alone.
TEST(ServoDrill, EditorAndServoNeitherBlockNorTear)
{
  DrilledBlock block;
  test::ServoRun run(block.Scene());
  Press(run);
  run.Loop.RunDrill(true);
  std::atomic<bool> isOver{false};
  std::thread editor(
      [&]
      {
        while (!isOver)
        {
          block.Editor->Take();
        }
      });
  std::thread viewer(
      [&]
      {
        while (!isOver)
        {
          const DrillReading reading = block.Editor->Newest();
          std::shared_ptr<const FieldSolid> solid;
          ASSERT_TRUE(FieldSolid::Make(reading.Fields[0], 0, solid).IsOk());
          unsigned char inside = 0;
          const Vector3 below(0.0, 0.0, 0.0);
          solid->AreInside(&below, 1, &inside);
          ASSERT_EQ(inside, 1);
        }
      });
  for (int n = 0; n < 2000; ++n)
  {
    const double angle = 0.01 * n;
    run.TickAt(Pressed + 2.0 * Vector3(std::cos(angle) - 1.0, std::sin(angle), 0.0));
  }
  isOver = true;
  editor.join();
  viewer.join();
  block.Editor->Take();
  EXPECT_EQ(block.Editor->Newest().Number, run.Loop.Latest().DrillOrders);
  EXPECT_GT(block.Editor->RemovedVolumes()[0], 1.0);
}
} // namespace
} // namespace palpate::servo_drill_test
