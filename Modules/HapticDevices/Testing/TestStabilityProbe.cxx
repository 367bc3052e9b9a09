#include "StabilityProbe.h"

#include "BareTrial.h"
#include "ManualClock.h"
#include "PressableScenes.h"
#include "StiffnessAdvice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::stability_probe_test
{
namespace
{
using Observation = StabilityObservation;
using test::BareTrial;

double Claimed(const StabilityTrial& trial, double damping)
{
  ManualClock clock;
  return StiffestStable(SimulatedDevice(clock, trial.Device).Capabilities(), trial.Loop.Rate,
                        damping)
      .Largest;
}

Observation Observe(const TouchScene& scene, const StabilityTrial& trial)
{
  Observation observation;
  const Status status = ObserveStability(scene, trial, observation);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return observation;
}

template <typename T>
const T& OneOf(test::Random& random, const std::vector<T>& choices)
{
  return choices[std::uniform_int_distribution<std::size_t>(0, choices.size() - 1)(random)];
}

// Any device and hand of the sweep, and the structure's share of the mechanism's damping.
StabilityTrial RandomTrial(test::Random& random, const Vector3& outward, double& damping)
{
  StabilityTrial trial = BareTrial(outward, OneOf<double>(random, {500.0, 1000.0, 4000.0}));
  trial.Device.Delay = OneOf<double>(random, {0.0, 1.0, 3.0}) / trial.Loop.Rate;
  trial.Device.Resolution = OneOf<double>(random, {0.0, 0.02, 0.045});
  HandProperties& hand = trial.Device.Hand;
  hand.Friction = trial.Device.Resolution > 0.0 ? OneOf<double>(random, {0.05, 0.2}) : 0.0;
  hand.Damping = OneOf<double>(random, {0.002, 0.01});
  hand.HandStiffness = OneOf<double>(random, {0.1, 0.5, 2.0});
  hand.HandDamping = OneOf<double>(random, {0.001, 0.005, 0.02});
  hand.Mass = OneOf<double>(random, {0.1, 0.25, 0.5});
  trial.Loop.VelocityTimeConstant = OneOf<double>(random, {0.0, 0.003});
  trial.Frequency = OneOf<double>(random, {2.0, 7.0});
  damping = OneOf<double>(random, {0.0, 0.3, 0.8}) * hand.Damping;
  return trial;
}

// The energy (N mm) that the tracker of a sphere of few points may add: it places the tool to 1e-3
// of a voxel, and the force may move by as much without work when another point becomes the
// sphere's contact.
double ShiftEnergy(double stiffness, double depth)
{
  constexpr double Enough = 1e-3;
  return stiffness * depth * Enough * test::pressable::VoxelSize;
}

TEST(StabilityProbe, AdvisedStructuresArePassive)
{
  constexpr int Trials = 60;
  test::Random random(71);
  std::vector<test::PressableScene> scenes = test::MakePressableScenes(random);
  for (test::PressableScene& pressed : scenes)
  {
    // The contact among its few points may change at rest, by less than a count.
    const bool mayShift = pressed.Kind == "sub-voxel, 26 points";
    for (int n = 0; n < Trials; ++n)
    {
      ContactLaw& law = pressed.Scene.Structures.front().Law;
      const StabilityTrial trial = RandomTrial(random, pressed.Outward, law.Damping);
      law.Stiffness = 0.99 * Claimed(trial, law.Damping);
      Observation seen = Observe(pressed.Scene, trial);
      EXPECT_EQ(seen.Fault, SafetyFault::None);
      EXPECT_GT(seen.Deepest, 0.02);
      seen.LeastEnergy += mayShift ? ShiftEnergy(law.Stiffness, seen.Deepest) : 0.0;
      const HandProperties& hand = trial.Device.Hand;
      EXPECT_FALSE(seen.GaveOutEnergy() || (seen.Vibrated() && !mayShift))
          << pressed.Kind << ": " << seen.LeastEnergy << " N mm, " << seen.LaterMotion << " after "
          << seen.EarlierMotion << " mm; " << law.Stiffness << " N/mm, " << law.Damping
          << " N s/mm; " << trial.Loop.Rate << " Hz, " << trial.Device.Delay
          << " s late, counts of " << trial.Device.Resolution << " mm; friction " << hand.Friction
          << ", damping " << hand.Damping << ", hand " << hand.HandStiffness << ' '
          << hand.HandDamping << ' ' << hand.Mass << ", filter " << trial.Loop.VelocityTimeConstant
          << ", " << trial.Frequency << " Hz";
    }
  }
}

TEST(StabilityProbe, StructuresBeyondLimitAreActive)
{
  test::Random random(73);
  for (test::PressableScene& pressed : test::MakePressableScenes(random))
  {
    const StabilityTrial trial = BareTrial(pressed.Outward);
    ContactLaw& law = pressed.Scene.Structures.front().Law;
    law.Stiffness = 4.0 * Claimed(trial, 0.0);
    EXPECT_TRUE(Observe(pressed.Scene, trial).GaveOutEnergy()) << pressed.Kind;
  }
}

// With all dissipation except the friction that quantisation needs.
TEST(StabilityProbe, QuantisationWithoutFrictionCausesLimitCycle)
{
  test::Random random(74);
  test::PressableScene wall = std::move(test::MakePressableScenes(random).front());
  StabilityTrial trial = BareTrial(wall.Outward);
  trial.Device.Resolution = 0.1;
  wall.Scene.Structures.front().Law.Stiffness = 3.0;
  EXPECT_TRUE(Observe(wall.Scene, trial).Vibrated());
  trial.Device.Hand.Friction = 0.2; // more than 3 N/mm * 0.1 mm / 2
  EXPECT_FALSE(Observe(wall.Scene, trial).Vibrated());
}

// A slowly moving hand comes close to the bound, which a hand at constant speed would reach.
TEST(StabilityProbe, LimitOfWallIsNearBound)
{
  test::Random random(75);
  const test::PressableScene wall = test::MakePressableScenes(random).front();
  const StabilityTrial trial = BareTrial(wall.Outward);
  const double claimed = Claimed(trial, 0.0);
  double border = 0.0;
  ASSERT_TRUE(FindStableBorder(
                  wall.Scene, trial, claimed,
                  [](const Observation& seen) { return !seen.GaveOutEnergy(); }, border)
                  .IsOk());
  EXPECT_GE(border, claimed);
  EXPECT_LE(border, 3.0 * claimed);
}

TEST(StabilityProbe, RejectsEmptyScene)
{
  Observation observation;
  double border = 0.0;
  const StabilityTrial trial = BareTrial(Vector3::UnitZ());
  EXPECT_FALSE(ObserveStability({}, trial, observation).IsOk());
  EXPECT_FALSE(FindStableBorder(
                   {}, trial, 1.0, [](const Observation&) { return true; }, border)
                   .IsOk());
}
} // namespace
} // namespace palpate::stability_probe_test
