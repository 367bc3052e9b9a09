#include "TurnLimit.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::turn_limit_test
{
namespace
{
using Orientation = std::array<double, 4>;

Orientation About(const Vector3& axis, double angle)
{
  Orientation turned;
  Eigen::Map<Eigen::Quaterniond>(turned.data()) = Eigen::AngleAxisd(angle, axis);
  return turned;
}

double AngleBetween(const Orientation& a, const Orientation& b)
{
  return Eigen::Map<const Eigen::Quaterniond>(a.data()).angularDistance(
      Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(b.data())));
}

TEST(TurnLimit, SlowTurnsKeepTheirBits)
{
  TurnLimit limit;
  for (int n = 0; n < 200; ++n)
  {
    const Orientation wanted = About(Vector3::UnitY(), 0.02 * n);
    Orientation followed = wanted;
    limit.Follow(0.001, followed);
    EXPECT_EQ(followed, wanted);
  }
}

TEST(TurnLimit, JumpIsFollowedAtTheLimitAndReached)
{
  TurnLimit limit;
  Orientation followed = About(Vector3::UnitX(), 0.0);
  limit.Follow(0.001, followed);
  const Orientation goal = About(Vector3::UnitX(), 2.0);
  for (int n = 1; n <= 50; ++n)
  {
    followed = goal;
    limit.Follow(0.001, followed);
    EXPECT_NEAR(AngleBetween(followed, goal), 2.0 - TurnLimit::MostTurn * 0.001 * n, 1e-9);
  }
  limit.Follow(0.001, followed = goal);
  EXPECT_LT(AngleBetween(followed, goal), 1e-7);
}

TEST(TurnLimit, OppositeSignIsNoTurn)
{
  TurnLimit limit;
  Orientation first = About(Vector3::UnitZ(), 0.3);
  limit.Follow(0.001, first);
  Orientation second = first;
  for (double& part : second)
  {
    part = -part;
  }
  limit.Follow(0.0, second);
  EXPECT_EQ(second, first);
}

TEST(TurnLimit, StaysUnitAndWithinTheLimitForAnyTurns)
{
  test::Random random(5);
  std::uniform_real_distribution<double> angle(-10.0, 10.0);
  std::uniform_real_distribution<double> period(-0.001, 0.01);
  TurnLimit limit;
  Orientation last = About(Vector3::UnitX(), 0.0);
  limit.Follow(0.001, last);
  for (int n = 0; n < 20000; ++n)
  {
    Orientation now = About(test::RandomDirection(random), angle(random));
    const double passed = period(random);
    limit.Follow(passed, now);
    ASSERT_NEAR(Eigen::Map<Eigen::Quaterniond>(now.data()).norm(), 1.0, 1e-12);
    ASSERT_LE(AngleBetween(now, last), TurnLimit::MostTurn * std::max(passed, 0.0) + 1e-7);
    last = now;
  }
}
} // namespace
} // namespace palpate::turn_limit_test
