#include "DrillForce.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::drill_force_test
{
namespace
{
const DrillLaw Bone{0.1, 0.01, 0.3};
const DrillMotion Burr{3.0, 1000.0, 120.0}; // 18.8 m/s

TEST(DrillForce, FeedIsProportionalToPushAndSpeed)
{
  EXPECT_NEAR(FeedRate(Bone, Burr, 2.0), 0.1 * 2.0 * 2.0 * M_PI * 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(FeedRate(Bone, {3.0, 500.0, 120.0}, 4.0), FeedRate(Bone, Burr, 2.0));
}

TEST(DrillForce, NoWearMeansNoFeedAndNoForce)
{
  const DrillLaw nerve{0.0, 0.01, 0.3};
  EXPECT_EQ(FeedRate(nerve, Burr, 5.0), 0.0);
  EXPECT_EQ(DrillForce(nerve, Burr, 5.0, Vector3::UnitZ(), Vector3(50.0, 0.0, 0.0), 1.0, 0.002),
            Vector3::Zero());
}

TEST(DrillForce, StoppedDrillAddsNothing)
{
  const DrillMotion still{3.0, 0.0, 120.0};
  EXPECT_EQ(FeedRate(Bone, still, 5.0), 0.0);
  EXPECT_EQ(DrillForce(Bone, still, 5.0, Vector3::UnitZ(), Vector3(50.0, 0.0, 0.0), 1.0, 0.002),
            Vector3::Zero());
}

TEST(DrillForce, IsZeroWithoutPush)
{
  for (const double push : {0.0, -1.0})
  {
    EXPECT_EQ(FeedRate(Bone, Burr, push), 0.0);
    EXPECT_EQ(DrillForce(Bone, Burr, push, Vector3::UnitZ(), Vector3(9.0, 0.0, 0.0), 1.0, 0.002),
              Vector3::Zero());
  }
}

TEST(DrillForce, VibratesInProportionToRemoval)
{
  const double quarter = 0.25 / Burr.VibrationFrequency;
  const auto swing = [&](double recession)
  { return DrillForce(Bone, Burr, 2.0, Vector3::UnitZ(), Vector3::Zero(), recession, quarter)[2]; };
  const double feed = FeedRate(Bone, Burr, 2.0);
  EXPECT_EQ(swing(0.0), 0.0);
  EXPECT_NEAR(swing(0.5 * feed), 0.5 * 0.3 * 2.0, 1e-12);
  EXPECT_NEAR(swing(feed), 0.3 * 2.0, 1e-12);
  EXPECT_NEAR(swing(10.0 * feed), 0.3 * 2.0, 1e-12);
}

TEST(DrillForce, NeverPullsAndDragIsPassive)
{
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::normal_distribution<double> component;
  const auto vector = [&]
  { return Vector3(component(random), component(random), component(random)); };
  for (int trial = 0; trial < 10000; ++trial)
  {
    const DrillLaw law{part(random), 10.0 * part(random), part(random)};
    const double push = 20.0 * part(random);
    const Vector3 normal = vector().normalized();
    const Vector3 velocity = 200.0 * vector();
    const Vector3 force =
        DrillForce(law, Burr, push, normal, velocity, 50.0 * part(random), 100.0 * part(random));
    EXPECT_GE(push + force.dot(normal), 0.0);
    const Vector3 along = force - force.dot(normal) * normal;
    EXPECT_LE(along.dot(velocity), 1e-9); // N mm/s, of rounding
    EXPECT_LE(along.norm(), push * (1.0 + 1e-12));
  }
}

TEST(DrillForce, VibrationIsTheSameAfterAHundredHours)
{
  // 120 Hz: whole periods in 1/24 s, and doubles still resolve 1e-10 s after so long.
  const double later = 360000.0;
  for (double time = 0.0; time < 0.01; time += 0.001)
  {
    const Vector3 now = DrillForce(Bone, Burr, 2.0, Vector3::UnitZ(), Vector3::Zero(), 100.0, time);
    const Vector3 then =
        DrillForce(Bone, Burr, 2.0, Vector3::UnitZ(), Vector3::Zero(), 100.0, later + time);
    EXPECT_NEAR(now[2], then[2], 1e-6);
  }
}
} // namespace
} // namespace palpate::drill_force_test
