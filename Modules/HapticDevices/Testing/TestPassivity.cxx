// A virtual wall on the simulated device gives out no more energy than it took in, wherever
// StiffnessAdvice calls it stable.
#include "SimulatedTouch.h"
#include "StiffnessAdvice.h"

#include <algorithm>

namespace palpate::passivity_test
{
namespace
{
struct WallCase
{
  double Rate = 1000.0; // Hz
  double DelayTicks = 0.0;
  double Resolution = 0.0;     // mm
  double Damping = 0.002;      // N s/mm, of the mechanism
  double WallDamping = 0.0;    // relative to the mechanism's
  double TimeConstant = 0.003; // s
  double Frequency = 2.0;      // Hz
};

SimulatedSettings DeviceOf(const WallCase& c)
{
  SimulatedSettings device;
  device.Path = test::PressingPath(3.0, c.Frequency);
  device.Rate = c.Rate;
  device.Delay = c.DelayTicks / c.Rate;
  device.Resolution = c.Resolution;
  device.Hand.Damping = c.Damping;
  // Friction helps against quantisation, and would hide the effect without it.
  device.Hand.Friction = c.Resolution > 0.0 ? 0.2 : 0.0;
  // Only the bounds under test.
  device.MaximumStiffness = 0.0;
  device.MaximumForce = 1000.0;
  device.MaximumDamping = 0.0;
  return device;
}

struct Session
{
  double LeastEnergy = 0.0; // N mm, absorbed by wall and mechanism, over all ticks
  int DampedTicks = 0;      // in which the energy observer was active
};

// A second at a wall of `share` times the advised stiffness.
Session PressWall(const WallCase& c, double share, double largestDamping = 0.0)
{
  SimulatedSettings device = DeviceOf(c);
  device.MaximumDamping = largestDamping;
  ServoSettings settings;
  settings.Rate = c.Rate;
  settings.RampDuration = 0.0;
  settings.MaximumSlew = 1e9;
  settings.VelocityTimeConstant = c.TimeConstant;
  ManualClock clock;
  const double wallDamping = c.WallDamping * c.Damping;
  const double stiffness =
      share *
      StiffestStable(SimulatedDevice(clock, device).Capabilities(), c.Rate, wallDamping).Largest;
  test::SimulatedTouch touch(test::WallScene(0.0, {stiffness, wallDamping}), device, settings);
  Session session;
  double deepest = 0.0;
  for (int n = 0; n < static_cast<int>(c.Rate); ++n)
  {
    const TouchState& state = touch.Tick();
    deepest = std::max(deepest, state.Depth);
    session.DampedTicks += state.Safety.IsDamping ? 1 : 0;
    session.LeastEnergy = std::min(session.LeastEnergy, touch.Device.Hand().Energy().TakenIn());
  }
  EXPECT_EQ(touch.Loop.Latest().Safety.Fault, SafetyFault::None);
  EXPECT_GT(deepest, 0.02); // the wall was touched
  return session;
}

// Calls `visit` with every combination of a moderate sweep.
template <typename Visit>
void ForAllWalls(Visit visit)
{
  for (const double rate : {500.0, 1000.0, 4000.0})
  {
    for (const double delay : {0.0, 1.0, 3.0})
    {
      for (const double resolution : {0.0, 0.045})
      {
        for (const double damping : {0.002, 0.01})
        {
          for (const double wallDamping : {0.0, 0.3, 0.8})
          {
            for (const double timeConstant : {0.0, 0.003})
            {
              for (const double frequency : {2.0, 7.0})
              {
                visit(WallCase{rate, delay, resolution, damping, wallDamping, timeConstant,
                               frequency});
              }
            }
          }
        }
      }
    }
  }
}

TEST(Passivity, AdvisedWallsArePassive)
{
  ForAllWalls(
      [](const WallCase& c)
      {
        // Where the hand reverses within a step of its integration, friction is misplaced by less
        // than this; these walls absorb around 1 N mm.
        EXPECT_GE(PressWall(c, 0.99).LeastEnergy, -1e-6)
            << c.Rate << " Hz, " << c.DelayTicks << " ticks late, counts of " << c.Resolution
            << " mm, mechanism " << c.Damping << ", wall " << c.WallDamping << " of it, filter "
            << c.TimeConstant << " s, hand " << c.Frequency << " Hz";
      });
}

TEST(Passivity, WallBeyondLimitIsActive)
{
  WallCase c;
  EXPECT_LT(PressWall(c, 6.0).LeastEnergy, -0.1);
  c.DelayTicks = 2.0;
  EXPECT_LT(PressWall(c, 6.0).LeastEnergy, -0.1);
}

TEST(Passivity, ObserverIsInactiveBelowHalfTheLimit)
{
  // Half, since a filtered velocity misses part of the mechanism's dissipation.
  ForAllWalls(
      [](const WallCase& c)
      {
        // With more damping of the wall, or later forces, less is guaranteed.
        if (c.DelayTicks == 0.0 && c.WallDamping < 0.5)
        {
          EXPECT_EQ(PressWall(c, 0.5, 0.02).DampedTicks, 0)
              << c.Rate << " Hz, counts of " << c.Resolution << " mm, mechanism " << c.Damping
              << ", wall " << c.WallDamping << " of it, filter " << c.TimeConstant << " s, hand "
              << c.Frequency << " Hz";
        }
      });
}

TEST(Passivity, ObserverDissipatesEnergyBeyondLimit)
{
  WallCase c;
  const double without = PressWall(c, 6.0).LeastEnergy;
  EXPECT_GT(PressWall(c, 6.0, 0.02).LeastEnergy, 0.2 * without);
}
} // namespace
} // namespace palpate::passivity_test
