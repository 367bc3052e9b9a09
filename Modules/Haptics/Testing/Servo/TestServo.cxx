#include "Servo.h"

#include "ForceField.h"
#include "RandomOrientation.h"
#include "ServoRun.h"

#include <gtest/gtest.h>

namespace palpate::servo_test
{
namespace
{
using test::WallScene;

// A wall that counts its queries.
struct CountedWall
{
  std::shared_ptr<test::WallControl> Control = std::make_shared<test::WallControl>();
  TouchScene Scene = WallScene(0.0, {1.0, 0.0}, this->Control);
};

TEST(Servo, WallPushesByItsStiffness)
{
  test::ServoRun run(WallScene(10.0, {0.8, 0.0}));
  EXPECT_EQ(run.RestAt({3.0, 4.0, 11.0}), Vector3::Zero());
  const Vector3 force = run.RestAt({3.0, 4.0, 8.0});
  EXPECT_NEAR((force - Vector3(0.0, 0.0, 1.6)).norm(), 0.0, 1e-12); // roundings
  EXPECT_EQ(run.Loop.Latest().Structure, 0);
  EXPECT_DOUBLE_EQ(run.Loop.Latest().Depth, 2.0);
  EXPECT_DOUBLE_EQ(run.Loop.Latest().ProxyWorld.Z, 10.0);
  EXPECT_TRUE(run.Loop.Latest().Safety.IsArmed);
}

TEST(Servo, DeviceIsShownTheTickWhoseForceWasApplied)
{
  test::ServoRun run(WallScene(10.0, {0.8, 0.0}));
  const Vector3 force = run.RestAt({3.0, 4.0, 8.0});
  const TouchState& shown = run.Device.Shown;
  EXPECT_EQ(Vector3(shown.ForceDevice), force);
  EXPECT_EQ(shown.Tick.Number, run.Loop.Latest().Tick.Number);
  EXPECT_DOUBLE_EQ(shown.ProxyWorld.Z, 10.0);
  EXPECT_TRUE(shown.WasTaken);
}

TEST(Servo, ToolHasASize)
{
  TouchScene scene = WallScene(0.0, {1.0, 0.0});
  scene.Tool = ToolShape::Sphere(2.5);
  test::ServoRun run(scene);
  EXPECT_NEAR(run.RestAt({0.0, 0.0, 2.0})[2], 0.5, 1e-12);
}

TEST(Servo, ForcesRotateWithTheDeviceAndStiffnessIgnoresScale)
{
  test::Random random(81);
  for (const double scale : {0.1, 1.0, 7.0})
  {
    const Matrix3 rotation = test::RandomOrientation(random);
    const Vector3 origin(30.0, -20.0, 100.0);
    TouchScene scene = WallScene(90.0, {0.5, 0.0});
    scene.Frame = DeviceFrame(rotation, scale, origin);
    test::ServoRun run(scene);
    // Two millimetres of the hand below the wall.
    const Vector3 world(31.0, -22.0, 90.0 - 2.0 * scale);
    const Vector3 force = run.RestAt(rotation.transpose() * (world - origin) / scale);
    const Vector3 expected = rotation.transpose() * Vector3(0.0, 0.0, 1.0);
    EXPECT_NEAR((force - expected).norm(), 0.0, 1e-10); // coordinates of 1000 mm, rounded
    EXPECT_NEAR((Vector3(run.Loop.Latest().ForceWorld) - Vector3::UnitZ()).norm(), 0.0, 1e-10);
    EXPECT_NEAR((Vector3(run.Loop.Latest().ProbeWorld) - world).norm(), 0.0, 1e-10);
  }
}

TEST(Servo, StructuresAddUp)
{
  TouchScene scene = WallScene(0.0, {0.5, 0.0});
  scene.Structures.push_back({"deeper", std::make_shared<test::WallModel>(-1.0), {2.0, 0.0}, {}});
  test::ServoRun run(scene);
  EXPECT_NEAR(run.RestAt({0.0, 0.0, -1.5})[2], 0.5 * 1.5 + 2.0 * 0.5, 1e-12);
  EXPECT_EQ(run.Loop.Latest().Structure, 0);
}

TEST(Servo, StructureOutOfReachIsNotQueried)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  run.RestAt({0.0, 0.0, 0.001});
  EXPECT_EQ(wall.Control->Questions, 0);
  run.TickAt({0.0, 0.0, -0.001});
  // The previous place, to know where it came from, and the current place.
  EXPECT_EQ(wall.Control->Questions, 2);
}

TEST(Servo, StructurePassedWithinOneTickIsQueried)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  run.TickAt({-502.0, 0.0, -1.0});
  run.TickAt({-500.5, 0.0, -1.0});
  EXPECT_EQ(wall.Control->Questions, 0);
  run.TickAt({-499.5, 0.0, 1.0});
  // Both places are outside; the box of the path overlaps the wall's.
  EXPECT_EQ(wall.Control->Questions, 2);
}

TEST(Servo, RepeatedSampleKeepsItsForce)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  const Vector3 force = run.RestAt({0.0, 0.0, -1.0});
  const int questions = wall.Control->Questions;
  run.Device.RepeatsSample = true;
  EXPECT_EQ(run.TickAt({0.0, 0.0, -1.0}), force);
  EXPECT_EQ(wall.Control->Questions, questions);
}

TEST(Servo, DeviceMayBeSilentForItsLongestGap)
{
  for (const double gap : {0.0, 0.004}) // s
  {
    test::ScriptedDevice device;
    device.Abilities.LongestGap = gap;
    Servo loop(device, ServoSettings());
    loop.Tick(test::HealthyTick(0).Tick);
    device.RepeatsSample = true;
    std::uint64_t silent = 0;
    while (silent < 100 && loop.Latest().Safety.Fault == SafetyFault::None)
    {
      loop.Tick(test::HealthyTick(++silent).Tick);
    }
    EXPECT_EQ(loop.Latest().Safety.Fault, SafetyFault::StaleSample);
    EXPECT_EQ(silent, gap > 0.0 ? 5U : 2U) << gap;
  }
}

TEST(Servo, ForceIsLimitedByTheDevice)
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.MaximumForce = 2.5;
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}), {}, device);
  EXPECT_NEAR(run.RestAt({0.0, 0.0, -2.4})[2], 2.4, 1e-12);
  const Vector3 force = run.RestAt({0.0, 0.0, -6.0});
  EXPECT_LE(force.norm(), 2.5);
  EXPECT_NEAR(force[2], 2.5, 1e-12);
  device.MaximumForce = 0.0;
  test::ServoRun unknown(WallScene(0.0, {1.0, 0.0}), {}, device);
  EXPECT_EQ(unknown.RestAt({0.0, 0.0, -1.0}), Vector3::Zero());
}

TEST(Servo, DampingIsLimitedByTheDevice)
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.MaximumDamping = 0.01;
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}), {}, device);
  run.RestAt({0.0, 0.0, -2.0});
  // Out at 50 mm/s: 2 N returned 0.1 N mm, which would require 0.04 N s/mm.
  EXPECT_NEAR(run.TickAt({0.0, 0.0, -1.95})[2], 1.95 - 0.01 * 50.0, 1e-9);
  EXPECT_TRUE(run.Loop.Latest().Safety.IsDamping);
}

TEST(Servo, CreditsDampingAndFrictionOfTheDevice)
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.Damping = 0.003;
  device.Friction = 0.2;
  test::ServoRun run(WallScene(0.0, {0.0, 0.0}), {}, device);
  double before = 0.0;
  for (int n = 0; n < 200; ++n)
  {
    before = run.Loop.Latest().Safety.Energy;
    run.TickAt({0.0, 0.0, -0.05 * n});
  }
  // At 50 mm/s, in 1 ms, with a settled filter.
  EXPECT_NEAR(run.Loop.Latest().Safety.Energy - before, (0.003 * 50.0 + 0.2) * 0.05, 1e-9);
}

TEST(Servo, StaleSampleEndsByItselfIfTheDeviceHasNoMotors)
{
  for (const bool hasMotors : {true, false})
  {
    DeviceCapabilities device = test::ScriptedDevice().Abilities;
    device.HasMotors = hasMotors;
    test::ServoRun run(WallScene(0.0, {1.0, 0.0}), {}, device);
    run.RestAt({0.0, 0.0, -1.0});
    run.Loop.Tick(test::HealthyTick(2000, Vector3::Zero()).Tick);
    EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::StaleSample);
    EXPECT_EQ(run.Loop.Latest().Safety.WillResume, !hasMotors);
  }
}

TEST(Servo, UsesRampAndSlewRateOfTheSettings)
{
  ServoSettings settings;
  settings.RampDuration = 0.1;
  settings.MaximumSlew = 10.0;
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}), settings);
  for (int n = 0; n <= 100; ++n)
  {
    // 3 N within 0.1 s would be 30 N/s.
    EXPECT_NEAR(run.TickAt({0.0, 0.0, -3.0})[2], 0.01 * n, 1e-12);
    EXPECT_EQ(run.Loop.Latest().Safety.IsRamping, n < 100);
  }
}

TEST(Servo, SwitchOffWinsOverRearm)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  for (const bool rearmsFirst : {true, false})
  {
    run.Loop.Rearm();
    ASSERT_GT(run.RestAt({0.0, 0.0, -1.0})[2], 0.9);
    rearmsFirst ? run.Loop.Rearm() : run.Loop.SwitchOff();
    rearmsFirst ? run.Loop.SwitchOff() : run.Loop.Rearm();
    for (int n = 0; n < 10; ++n)
    {
      EXPECT_EQ(run.TickAt({0.0, 0.0, -1.0}), Vector3::Zero());
      EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::SwitchedOff);
    }
  }
}

TEST(Servo, RearmRestartsContacts)
{
  CountedWall wall;
  wall.Scene.Structures[0].Id = 1;
  test::ServoRun run(wall.Scene);
  run.RestAt({0.0, 0.0, -1.0});
  const int questions = wall.Control->Questions;
  run.Loop.Rearm();
  // So the scene has nothing to continue from, and the wall is queried as new: whether the place is
  // free, and the force.
  ASSERT_TRUE(
      run.Loop.Publish(std::make_shared<TouchScene>(wall.Scene), SceneEntry::Continuing).IsOk());
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_FALSE(run.Loop.Latest().WasContinued);
  EXPECT_EQ(wall.Control->Questions, questions + 2);
  run.Loop.Rearm();
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(wall.Control->Questions, questions + 4);
}

// N everywhere, as of a guide far away.
class SteadyPull final : public ForceField
{
public:
  Vector3 ForceWorld(const Vector3&) const noexcept override { return {3.0, 0.0, 0.0}; }
  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    return {Vector3::Constant(-1e3), Vector3::Constant(1e3)};
  }
  double Stiffness() const noexcept override { return 0.0; }
};

constexpr std::uint32_t ClutchButton = 4;

// A hand in a wall, pulled aside by a field.
test::ServoRun PulledRun()
{
  TouchScene scene = WallScene(0.0, {1.0, 0.0});
  scene.Fields.push_back(std::make_shared<SteadyPull>());
  ServoSettings settings;
  settings.ClutchButtons = ClutchButton;
  return test::ServoRun(scene, settings);
}

TEST(Servo, ClutchButtonEndsContactsAndFieldsWithoutOtherThreads)
{
  test::ServoRun run = PulledRun();
  const Vector3 hand(0.0, 0.0, -1.0);
  ASSERT_NEAR(run.RestAt(hand).norm(), std::hypot(1.0, 3.0), 1e-12);
  run.Device.Next.Buttons = ClutchButton;
  run.TickAt(hand); // by the slew limit
  EXPECT_EQ(run.TickAt(hand), Vector3::Zero());
  EXPECT_TRUE(run.Loop.Latest().IsClutched);
  EXPECT_EQ(run.Loop.Latest().Structure, -1);
  EXPECT_EQ(run.RestAt(hand), Vector3::Zero());
  // Also when a scene is published in the meantime.
  ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(WallScene(0.0, {1.0, 0.0}))).IsOk());
  EXPECT_EQ(run.RestAt(hand), Vector3::Zero());
}

TEST(Servo, AnotherClutchButtonTakesOverInTheNextTick)
{
  test::ServoRun run = PulledRun();
  const Vector3 hand(0.0, 0.0, 1.0);
  run.RestAt(hand);
  run.Loop.SetClutchButtons(2 * ClutchButton);
  run.Device.Next.Buttons = ClutchButton;
  EXPECT_EQ(run.RestAt(hand), Vector3(3.0, 0.0, 0.0));
  run.Device.Next.Buttons = 2 * ClutchButton;
  run.TickAt(hand); // by the slew limit
  EXPECT_EQ(run.TickAt(hand), Vector3::Zero());
  EXPECT_TRUE(run.Loop.Latest().IsClutched);
}

TEST(Servo, ClutchEndsOnceItsButtonIsUpAndItWasReleased)
{
  test::ServoRun run = PulledRun();
  const Vector3 hand(0.0, 0.0, 1.0);
  run.RestAt(hand);
  run.Device.Next.Buttons = ClutchButton;
  run.RestAt(hand);
  run.Loop.ReleaseClutch();
  EXPECT_EQ(run.RestAt(hand), Vector3::Zero());
  run.Device.Next.Buttons = 0;
  EXPECT_EQ(run.RestAt(hand), Vector3::Zero());
  run.Loop.ReleaseClutch();
  EXPECT_EQ(run.RestAt(hand), Vector3(3.0, 0.0, 0.0));
}

TEST(Servo, StaysOffAlsoBeforeATickHasSwitchedOff)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  run.RestAt({0.0, 0.0, 1.0});
  EXPECT_FALSE(run.Loop.StaysOff());
  run.Loop.SwitchOff();
  EXPECT_TRUE(run.Loop.StaysOff());
  run.TickAt({0.0, 0.0, 1.0});
  EXPECT_TRUE(run.Loop.StaysOff());
  run.Loop.Rearm();
  run.TickAt({0.0, 0.0, 1.0});
  EXPECT_FALSE(run.Loop.StaysOff());
}

TEST(Servo, QueriesNoModelBeforeTheDeviceIsReady)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  run.Device.Life = DeviceState::Homing;
  run.RestAt({0.0, 0.0, -1.0});
  EXPECT_EQ(wall.Control->Questions, 0);
  run.Device.Life = DeviceState::Ready;
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(wall.Control->Questions, 2);
}

TEST(Servo, QueriesNoModelForNonFinitePositions)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  run.RestAt({0.0, 0.0, -1.0});
  const int questions = wall.Control->Questions;
  EXPECT_EQ(run.TickAt({0.0, test::NotANumber, -1.0}), Vector3::Zero());
  EXPECT_EQ(wall.Control->Questions, questions);
  EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::NonFinitePosition);
}

TEST(Servo, RefusedForceIsAFault)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  run.RestAt({0.0, 0.0, -1.0});
  run.Device.RefusesForce = true;
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_FALSE(run.Loop.Latest().WasTaken);
  EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::UntakenForce);
  run.Device.RefusesForce = false;
  EXPECT_EQ(run.TickAt({0.0, 0.0, -1.0}), Vector3::Zero());
  EXPECT_TRUE(run.Loop.Latest().WasTaken);
}

TEST(Servo, ForcesMayBeRefusedForTheDevicesLongestGap)
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.LongestGap = 0.008; // s, eight ticks
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}), ServoSettings(), device);
  run.RestAt({0.0, 0.0, -1.0});
  run.Device.RefusesForce = true;
  for (int tick = 1; tick <= 8; ++tick)
  {
    run.TickAt({0.0, 0.0, -1.0});
    EXPECT_EQ(run.Loop.Latest().Safety.Fault,
              tick < 8 ? SafetyFault::None : SafetyFault::UntakenForce)
        << tick;
  }
}

TEST(Servo, GravityCompensationPassesTheSafetyChain)
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.GravityCompensation = Vector3(0.0, 2.0, 0.0);
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}), ServoSettings(), device);
  EXPECT_LT(run.TickAt({0.0, 0.0, 1.0}).norm(), 0.1) << "it fades in";
  EXPECT_EQ(run.RestAt({0.0, 0.0, 1.0}), Vector3(0.0, 2.0, 0.0));
  run.Loop.SwitchOff();
  EXPECT_EQ(run.TickAt({0.0, 0.0, 1.0}), Vector3::Zero());
}

TEST(Servo, InvalidContactIsAFault)
{
  using test::WallFault;
  for (const WallFault fault : {WallFault::Invalid, WallFault::NaNProxy, WallFault::InfiniteProxy,
                                WallFault::HugeDepth, WallFault::NaNNormal, WallFault::NoNormal})
  {
    CountedWall wall;
    test::ServoRun run(wall.Scene);
    ASSERT_GT(run.RestAt({0.0, 0.0, -1.0})[2], 0.9);
    wall.Control->Fault = fault;
    EXPECT_EQ(run.TickAt({0.0, 0.0, -1.0}), Vector3::Zero());
    EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::InvalidContact);
  }
}

TEST(Servo, TicksTellThatAProxyIsBehind)
{
  CountedWall first;
  first.Scene.Structures.push_back(WallScene(-0.5, {1.0, 0.0}).Structures[0]);
  test::ServoRun run(first.Scene);
  run.RestAt({0.0, 0.0, -1.0});
  EXPECT_FALSE(run.Loop.Latest().IsBehind);
  first.Control->IsBehind = true;
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_TRUE(run.Loop.Latest().IsBehind);
}

TEST(Servo, NoForceWithoutAScene)
{
  test::ScriptedDevice device;
  Servo servo(device, ServoSettings());
  for (std::uint64_t n = 0; n < 10; ++n)
  {
    device.Next.Time = test::HealthyTick(n).Sample.Time;
    servo.Tick(test::HealthyTick(n).Tick);
    EXPECT_EQ(device.Applied, Vector3::Zero());
    EXPECT_EQ(servo.Latest().Scene, 0u);
  }
}

TEST(Servo, NewSceneFadesIn)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  const Vector3 inside(0.0, 0.0, -1.0);
  EXPECT_NEAR(run.RestAt(inside)[2], 1.0, 1e-12);
  ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(WallScene(3.0, {1.0, 0.0}))).IsOk());
  double last = 1.0;
  for (int n = 0; n < 350; ++n)
  {
    const double force = run.TickAt(inside)[2];
    // 2000 N/s down to zero, then up within 0.3 s, by no step above 4 N / 300.
    EXPECT_LE(force - last, 4.0 / 300.0 + 1e-12);
    last = force;
  }
  EXPECT_NEAR(last, 4.0, 1e-12);
  EXPECT_EQ(run.Loop.Latest().Scene, 2u);
}

TEST(Servo, NewSceneIgnoresEarlierMotion)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  run.RestAt({0.0, 0.0, -1.0});
  // The hand stays in place in the device, and moves to 99 mm above the wall.
  CountedWall wall;
  wall.Scene.Frame = DeviceFrame(Matrix3::Identity(), 1.0, {0.0, 0.0, 100.0});
  ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(wall.Scene)).IsOk());
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(wall.Control->Questions, 0);
}

TEST(Servo, EnergyEndsWithTheContact)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  run.RestAt({0.0, 0.0, -0.5});
  run.TickAt({0.0, 0.0, -1.5});
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_NEAR(run.Loop.Latest().Safety.Energy, 0.5 - 0.75, 1e-12);
  run.RestAt({0.0, 0.0, 1.0});
  EXPECT_EQ(run.Loop.Latest().Safety.Energy, 0.0);
}

TEST(Servo, OneInvalidContactOfManyIsAFault)
{
  CountedWall first;
  first.Scene.Structures.push_back(WallScene(-0.5, {1.0, 0.0}).Structures[0]);
  test::ServoRun run(first.Scene);
  ASSERT_GT(run.RestAt({0.0, 0.0, -1.0})[2], 0.9);
  first.Control->Fault = test::WallFault::Invalid;
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::InvalidContact);
}

TEST(Servo, DampingActsInwardsAndNeverPulls)
{
  test::ServoRun run(WallScene(0.0, {0.5, 0.02}));
  run.RestAt({0.0, 0.0, 0.5});
  double into = 0.0;
  for (int n = 0; n < 60; ++n)
  {
    into = run.TickAt({0.0, 0.0, 0.5 - 0.05 * n})[2];
  }
  // 2.45 mm and 50 mm/s; the filter has settled after 17 time constants.
  EXPECT_NEAR(into, 0.5 * 2.45 + 0.02 * 50.0, 1e-6);
  for (int n = 0; n < 60; ++n)
  {
    EXPECT_GE(run.TickAt({0.0, 0.0, -2.45 + 0.2 * n})[2], 0.0);
  }
}

TEST(Servo, SlowModelIsQueriedAtItsIntervalAndInterpolated)
{
  CountedWall wall;
  ServoSettings settings;
  settings.ModelInterval = 4;
  test::ServoRun run(wall.Scene, settings);
  run.RestAt({0.0, 0.0, -0.5});
  const int questions = wall.Control->Questions;
  double z = -0.5;
  for (int n = 0; n < 40; ++n)
  {
    z -= 0.02;
    // A plane is exact between the results.
    EXPECT_NEAR(run.TickAt({0.0, 0.0, z})[2], -z, 1e-12);
  }
  EXPECT_EQ(wall.Control->Questions, questions + 10);
}

TEST(Servo, RecordsEveryTickInOrder)
{
  ServoSettings settings;
  settings.RecordedTicks = 100;
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}), settings);
  run.RestAt(Vector3::Zero());
  TouchState state;
  for (std::uint64_t n = 0; n < 100; ++n)
  {
    ASSERT_TRUE(run.Loop.PopRecorded(state));
    EXPECT_EQ(state.Tick.Number, n);
  }
  EXPECT_FALSE(run.Loop.PopRecorded(state));
  EXPECT_EQ(run.Loop.LostTicks(), 500u);
}

TEST(Servo, RejectedSceneKeepsThePreviousOne)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  TouchScene shell = WallScene(0.0, {1.0, 0.0});
  shell.Tool = ToolShape::Ellipsoid({1.0, 1.0, 2.0}, 50);
  EXPECT_EQ(run.Loop.Publish(std::make_shared<TouchScene>(shell)).Message(),
            "The structure wall cannot be touched: it is touched by spheres and points only.");
  EXPECT_FALSE(run.Loop.Publish(nullptr).IsOk());
  EXPECT_NEAR(run.RestAt({0.0, 0.0, -1.0})[2], 1.0, 1e-12);
  EXPECT_EQ(run.Loop.Latest().Scene, 1u);
}
} // namespace
} // namespace palpate::servo_test
