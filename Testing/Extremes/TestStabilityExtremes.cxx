// Stiffness, rate, delay and encoder resolution beyond those of stable walls.
#include "BareTrial.h"
#include "PressableScenes.h"
#include "SimulatedTouch.h"
#include "StabilityProbe.h"
#include "StiffnessAdvice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace palpate::stability_extremes_test
{
namespace
{
StabilityObservation PressWall(const StabilityTrial& trial, double stiffness)
{
  StabilityObservation seen;
  const Status status = ObserveStability(test::WallScene(0.0, {stiffness, 0.0}), trial, seen);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return seen;
}

double Claimed(const StabilityTrial& trial)
{
  ManualClock clock;
  return StiffestStable(SimulatedDevice(clock, trial.Device).Capabilities(), trial.Loop.Rate, 0.0)
      .Largest;
}

// Within the claimed limit no energy is generated; at eight times the limit it is.
void ExpectBorder(const StabilityTrial& trial)
{
  const double claimed = Claimed(trial);
  const StabilityObservation within = PressWall(trial, 0.99 * claimed);
  EXPECT_EQ(within.Fault, SafetyFault::None);
  EXPECT_GT(within.Deepest, 0.01);
  EXPECT_FALSE(within.GaveOutEnergy()) << within.LeastEnergy << " N mm; " << claimed << " N/mm, "
                                       << trial.Loop.Rate << " Hz, " << trial.Device.Delay << " s";
  EXPECT_TRUE(PressWall(trial, 8.0 * claimed).GaveOutEnergy())
      << claimed << " N/mm, " << trial.Loop.Rate << " Hz, " << trial.Device.Delay << " s";
}

TEST(StabilityExtremes, ClaimedLimitHoldsFrom125HzTo20KHz)
{
  for (const double rate : {125.0, 20000.0})
  {
    ExpectBorder(test::BareTrial(Vector3::UnitZ(), rate));
  }
}

TEST(StabilityExtremes, ClaimedLimitHoldsForDelaysOfFiftyMilliseconds)
{
  for (const double delay : {0.01, 0.05})
  {
    StabilityTrial trial = test::BareTrial(Vector3::UnitZ(), 1000.0);
    trial.Device.Delay = delay;
    ExpectBorder(trial);
  }
}

// The watchdog treats periods longer than its 10 ms as a hanging servo.
TEST(StabilityExtremes, NoForceBelowAHundredHertz)
{
  EXPECT_EQ(PressWall(test::BareTrial(Vector3::UnitZ(), 100.0), 0.1).Fault, SafetyFault::None);
  EXPECT_EQ(PressWall(test::BareTrial(Vector3::UnitZ(), 99.0), 0.1).Fault,
            SafetyFault::StalledTick);
}

// Result of pressing a wall for a second, with the default device and safety chain.
struct Press
{
  double LargestForce = 0.0; // N
  double FastestHand = 0.0;  // mm/s
  bool IsFinite = true;
  SafetyFault Fault = SafetyFault::None;
};

Press PressForASecond(double stiffness, double delay)
{
  SimulatedSettings device;
  device.Path = test::PressingPath(3.0, 2.0);
  device.Delay = delay;
  test::SimulatedTouch touch(test::WallScene(0.0, {stiffness, 0.0}), device);
  Press press;
  for (int n = 0; n < 1000; ++n)
  {
    const TouchState& state = touch.Tick();
    const SimulatedHand& hand = touch.Device.Hand();
    const Vector3 force = state.ForceDevice;
    press.IsFinite = press.IsFinite && force.allFinite() && hand.Position().allFinite();
    press.LargestForce = std::max(press.LargestForce, force.norm());
    press.FastestHand = std::max(press.FastestHand, hand.Velocity().norm());
    press.Fault = state.Safety.Fault;
  }
  return press;
}

// Beyond the limit the chain bounds the force, but not the motion: it vibrates.
TEST(StabilityExtremes, ForcesAndSpeedsStayBoundedBeyondEveryLimit)
{
  const SimulatedSettings device;
  // The speed that alternating full force sustains against the damping of hand and mechanism, by
  // the first term of its Fourier series; and the hand's own motion.
  const double sustained =
      4.0 / M_PI * device.MaximumForce / (device.Hand.Damping + device.Hand.HandDamping);
  constexpr double OwnMotion = 100.0; // mm/s
  for (const double stiffness : {4.0, 40.0, 400.0, 1e6})
  {
    for (const double delay : {0.0, 0.005, 0.05})
    {
      const Press press = PressForASecond(stiffness, delay);
      EXPECT_TRUE(press.IsFinite) << stiffness << ' ' << delay;
      EXPECT_LE(press.LargestForce, device.MaximumForce * (1.0 + 1e-12)) << stiffness; // rounding
      EXPECT_LE(press.FastestHand, sustained + OwnMotion) << stiffness << ' ' << delay;
    }
  }
}

TEST(StabilityExtremes, AbsurdStiffnessSwitchesForcesOff)
{
  const Press press = PressForASecond(1e15, 0.0);
  EXPECT_EQ(press.LargestForce, 0.0);
  EXPECT_EQ(press.Fault, SafetyFault::NonFiniteForce);
}

// Encoders with a resolution of whole millimetres.
SimulatedSettings CoarseDevice(double height)
{
  SimulatedSettings device;
  device.Resolution = 1.0;
  device.Hand.HandStiffness = 20.0; // so that it reaches its goal
  device.Path = [height](double) { return Vector3(0.0, 0.0, height); };
  return device;
}

TEST(StabilityExtremes, DepthIsRoundedToWholeCounts)
{
  for (const auto& [height, felt] : {std::pair(-0.45, 0.0), {-0.7, 0.4}, {-1.4, 0.4}})
  {
    test::SimulatedTouch touch(test::WallScene(0.0, {0.4, 0.0}), CoarseDevice(height));
    EXPECT_NEAR(touch.Tick(2000).ForceDevice.Z, felt, 1e-12) << height;
    EXPECT_EQ(touch.Loop.Latest().Safety.Fault, SafetyFault::None);
  }
}

TEST(StabilityExtremes, CountsCoarserThanTheDepthAreStableUpToTheClaimedLimit)
{
  StabilityTrial trial = test::BareTrial(Vector3::UnitZ(), 1000.0);
  trial.Device.Resolution = 1.0;
  trial.Device.Hand.Friction = 0.2;
  trial.Depth = 0.8;                     // mm, less than a count
  const double claimed = Claimed(trial); // 2 f / D, 0.4 N/mm
  EXPECT_NEAR(claimed, 0.4, 1e-12);
  const StabilityObservation within = PressWall(trial, 0.99 * claimed);
  EXPECT_FALSE(within.GaveOutEnergy());
  EXPECT_FALSE(within.Vibrated());
  // Without the friction that hides the encoder resolution the hand is pushed to and fro.
  trial.Device.Hand.Friction = 0.0;
  EXPECT_TRUE(PressWall(trial, 0.99 * claimed).Vibrated());
}
} // namespace
} // namespace palpate::stability_extremes_test
