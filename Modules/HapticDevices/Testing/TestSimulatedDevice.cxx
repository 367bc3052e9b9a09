#include "ManualClock.h"
#include "SimulatedDevice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::simulated_device_test
{
namespace
{
constexpr std::int64_t Period = 1'000'000; // ns

// A hand at rest, without friction and quantisation, so that the smallest force has an effect.
SimulatedSettings Free()
{
  SimulatedSettings settings;
  settings.Hand.Friction = 0.0;
  settings.Resolution = 0.0;
  return settings;
}

DeviceSample ReadAfter(ManualClock& clock, SimulatedDevice& device, std::int64_t duration)
{
  clock.Advance(duration);
  DeviceSample sample;
  EXPECT_TRUE(device.Read(sample));
  return sample;
}

TEST(SimulatedDevice, HandFollowsPath)
{
  ManualClock clock;
  SimulatedSettings settings;
  settings.Path = [](double t)
  { return Vector3(20.0 - 20.0 * std::cos(2.0 * t), 0.0, 2.0 * t * t); };
  SimulatedDevice device(clock, settings);
  ASSERT_TRUE(device.Open().IsOk());
  for (int n = 1; n <= 2000; ++n)
  {
    const DeviceSample sample = ReadAfter(clock, device, Period);
    EXPECT_EQ(sample.Sequence, static_cast<std::uint64_t>(n));
    EXPECT_EQ(sample.Time, clock.Now());
    // On 0.5 N/mm: friction of 0.2 N, twice where it slips; damping of 0.09 N, inertia and start
    // of 0.02 N each; and half a count along each axis.
    ASSERT_LE((Vector3(sample.Position) - settings.Path(1e-3 * n)).norm(), 1.1) << n;
  }
}

TEST(SimulatedDevice, HandFollowsSetTarget)
{
  ManualClock clock;
  SimulatedDevice device(clock, Free());
  ASSERT_TRUE(device.Open().IsOk());
  device.LeadHand({1.0, 2.0, 3.0});
  // The hand takes as long as the time between two reads to get to a new target.
  ReadAfter(clock, device, Period);
  const DeviceSample sample = ReadAfter(clock, device, 2000 * Period);
  EXPECT_NEAR((Vector3(sample.Position) - Vector3(1.0, 2.0, 3.0)).norm(), 0.0, 1e-6);
}

TEST(SimulatedDevice, PositionsAreWholeCounts)
{
  ManualClock clock;
  SimulatedSettings settings;
  settings.Path = [](double t) { return Vector3(30.0 * t, 10.0 * t, -20.0 * t); };
  SimulatedDevice device(clock, settings);
  ASSERT_TRUE(device.Open().IsOk());
  for (int n = 0; n < 500; ++n)
  {
    const Vector3 counts = Vector3(ReadAfter(clock, device, Period).Position) / 0.045;
    ASSERT_NEAR((counts - Vector3(counts.array().round())).norm(), 0.0, 1e-12);
    ASSERT_LE((Vector3(ReadAfter(clock, device, 0).Position) - device.Hand().Position())
                  .cwiseAbs()
                  .maxCoeff(),
              0.5 * 0.045 + 1e-12);
  }
}

TEST(SimulatedDevice, ForceTakesEffectAfterDelay)
{
  ManualClock clock;
  SimulatedSettings settings = Free();
  settings.Delay = 0.0025;
  SimulatedDevice device(clock, settings);
  ASSERT_TRUE(device.Open().IsOk());
  ASSERT_TRUE(device.Apply({1.0, 0.0, 0.0}));
  EXPECT_EQ(ReadAfter(clock, device, 2'500'000).Position.X, 0.0);
  EXPECT_GT(ReadAfter(clock, device, 10'000).Position.X, 0.0);
}

TEST(SimulatedDevice, SaturationKeepsDirection)
{
  ManualClock clock;
  SimulatedDevice device(clock, Free());
  ASSERT_TRUE(device.Open().IsOk());
  ASSERT_TRUE(device.Apply({300.0, 400.0, 0.0}));
  ReadAfter(clock, device, 10'000);
  // The first step's motion: half of 8 N / 0.25 kg (10 us)^2, minus a little damping.
  const Vector3 expected = 0.5 * 8.0 / 0.25 * 1e-7 * Vector3(0.6, 0.8, 0.0);
  EXPECT_NEAR((device.Hand().Position() - expected).norm(), 0.0, 1e-4 * expected.norm());
}

TEST(SimulatedDevice, MotorsSwitchOffWithoutCommands)
{
  ManualClock clock;
  SimulatedDevice device(clock, Free());
  ASSERT_TRUE(device.Open().IsOk());
  ASSERT_TRUE(device.Apply({5.0, 0.0, 0.0}));
  const double pushed = ReadAfter(clock, device, 19 * Period).Position.X;
  EXPECT_GT(pushed, 1.0);
  EXPECT_NEAR(ReadAfter(clock, device, 3000 * Period).Position.X, 0.0, 1e-6);
}

TEST(SimulatedDevice, IsDeterministic)
{
  const auto run = []
  {
    ManualClock clock;
    SimulatedSettings settings = Free();
    settings.Path = [](double t) { return Vector3(10.0 * std::sin(9.0 * t), t, 0.0); };
    SimulatedDevice device(clock, settings);
    EXPECT_TRUE(device.Open().IsOk());
    Vector3 position = Vector3::Zero();
    for (int n = 0; n < 300; ++n)
    {
      position = ReadAfter(clock, device, Period + n * 1717).Position;
      EXPECT_TRUE(device.Apply(-0.3 * position));
    }
    return position;
  };
  EXPECT_EQ(run(), run());
}

TEST(SimulatedDevice, RefusesForceWhileHoming)
{
  ManualClock clock;
  SimulatedSettings settings = Free();
  settings.HomingDuration = 0.01;
  SimulatedDevice device(clock, settings);
  ASSERT_TRUE(device.Open().IsOk());
  for (int n = 1; n < 10; ++n)
  {
    EXPECT_EQ(ReadAfter(clock, device, Period).Position.X, 17.0);
    EXPECT_EQ(device.State(), DeviceState::Homing);
    EXPECT_TRUE(device.Apply({5.0, 0.0, 0.0}));
  }
  EXPECT_EQ(ReadAfter(clock, device, Period).Position.X, 0.0);
  EXPECT_EQ(device.State(), DeviceState::Ready);
}

TEST(SimulatedDevice, UnpluggedDeviceMustBeReopened)
{
  ManualClock clock;
  SimulatedDevice device(clock, SimulatedSettings());
  DeviceSample sample;
  EXPECT_FALSE(device.Read(sample));
  ASSERT_TRUE(device.Open().IsOk());
  EXPECT_FALSE(device.Open().IsOk());
  device.Inject(SimulatedFault::Unplugged);
  EXPECT_FALSE(device.Read(sample));
  EXPECT_FALSE(device.Apply(Vector3::Zero()));
  EXPECT_EQ(device.State(), DeviceState::Error);
  EXPECT_FALSE(device.Problem().empty());
  EXPECT_FALSE(device.Open().IsOk());
  device.Inject(SimulatedFault::None);
  device.Close();
  EXPECT_TRUE(device.Open().IsOk());
  EXPECT_TRUE(device.Read(sample));
  EXPECT_TRUE(device.Problem().empty());
}
} // namespace
} // namespace palpate::simulated_device_test
