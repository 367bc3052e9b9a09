#include "Servo.h"

#include "RandomOrientation.h"
#include "ServoRun.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::WallScene;

// A wall that counts its questions.
struct CountedWall
{
  std::shared_ptr<test::WallControl> Control = std::make_shared<test::WallControl>();
  TouchScene Scene = WallScene(0.0, {1.0, 0.0}, this->Control);
};

TEST(Servo, AWallPushesByItsStiffness)
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

TEST(Servo, TheToolHasASize)
{
  TouchScene scene = WallScene(0.0, {1.0, 0.0});
  scene.Tool = ToolShape::Sphere(2.5);
  test::ServoRun run(scene);
  EXPECT_NEAR(run.RestAt({0.0, 0.0, 2.0})[2], 0.5, 1e-12);
}

TEST(Servo, ForcesTurnWithTheDeviceAndTheHandFeelsTheSameStiffnessAtAnyScale)
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

TEST(Servo, AmbientForcesActWithoutTouch)
{
  TouchScene scene = WallScene(-100.0, {1.0, 0.0});
  scene.Ambient = {{0.0, 0.7, 0.0}, 0.002};
  test::ServoRun run(scene);
  EXPECT_NEAR((run.RestAt(Vector3::Zero()) - Vector3(0.0, 0.7, 0.0)).norm(), 0.0, 1e-12);
  Vector3 force = Vector3::Zero();
  for (int n = 1; n < 200; ++n)
  {
    force = run.TickAt({0.1 * n, 0.0, 0.0});
  }
  // 100 mm/s, known up to the filter's rest after 66 time constants.
  EXPECT_NEAR((force - Vector3(-0.2, 0.7, 0.0)).norm(), 0.0, 1e-9);
}

TEST(Servo, AStructureOutOfReachIsNotAsked)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  run.RestAt({0.0, 0.0, 0.001});
  EXPECT_EQ(wall.Control->Questions, 0);
  run.TickAt({0.0, 0.0, -0.001});
  // The place before, to know where it came from, and the place now.
  EXPECT_EQ(wall.Control->Questions, 2);
}

TEST(Servo, AStructureThatWasPassedWithinOneTickIsAsked)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  run.TickAt({-502.0, 0.0, -1.0});
  run.TickAt({-500.5, 0.0, -1.0});
  EXPECT_EQ(wall.Control->Questions, 0);
  run.TickAt({-499.5, 0.0, 1.0});
  // Both places are outside; the box of the way reaches into the wall's.
  EXPECT_EQ(wall.Control->Questions, 2);
}

TEST(Servo, ARepeatedSampleIsNotFeltAgainAndKeepsItsForce)
{
  CountedWall wall;
  test::ServoRun run(wall.Scene);
  const Vector3 force = run.RestAt({0.0, 0.0, -1.0});
  const int questions = wall.Control->Questions;
  run.Device.RepeatsSample = true;
  EXPECT_EQ(run.TickAt({0.0, 0.0, -1.0}), force);
  EXPECT_EQ(wall.Control->Questions, questions);
}

TEST(Servo, ADeviceMayBeSilentForAsLongAsItSaysAndNoLonger)
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

TEST(Servo, WithoutASceneThereIsNoForce)
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

TEST(Servo, ANewSceneFadesIn)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  const Vector3 inside(0.0, 0.0, -1.0);
  EXPECT_NEAR(run.RestAt(inside)[2], 1.0, 1e-12);
  ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(WallScene(3.0, {1.0, 0.0}))).IsOk());
  double last = 1.0;
  for (int n = 0; n < 350; ++n)
  {
    const double force = run.TickAt(inside)[2];
    // 2000 N/s down to nothing at once, then up within 0.3 s, by no step above 4 N / 300.
    EXPECT_LE(force - last, 4.0 / 300.0 + 1e-12);
    last = force;
  }
  EXPECT_NEAR(last, 4.0, 1e-12);
  EXPECT_EQ(run.Loop.Latest().Scene, 2u);
}

TEST(Servo, DampingIsFeltGoingInAndNeverPullsComingOut)
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

TEST(Servo, ASlowModelIsAskedAtItsIntervalAndFeltAtEveryTick)
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
    // A plane is known exactly between the results.
    EXPECT_NEAR(run.TickAt({0.0, 0.0, z})[2], -z, 1e-12);
  }
  EXPECT_EQ(wall.Control->Questions, questions + 10);
}

TEST(Servo, EveryTickIsRecordedInOrder)
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

TEST(Servo, ARefusedSceneLeavesTheOneBefore)
{
  test::ServoRun run(WallScene(0.0, {1.0, 0.0}));
  TouchScene shell = WallScene(0.0, {1.0, 0.0});
  shell.Tool = ToolShape::Capsule(1.0, 2.0, 50);
  EXPECT_EQ(run.Loop.Publish(std::make_shared<TouchScene>(shell)).Message(),
            "The structure wall cannot be touched: A wall feels spheres only.");
  EXPECT_FALSE(run.Loop.Publish(nullptr).IsOk());
  EXPECT_NEAR(run.RestAt({0.0, 0.0, -1.0})[2], 1.0, 1e-12);
  EXPECT_EQ(run.Loop.Latest().Scene, 1u);
}
} // namespace
} // namespace palpate
