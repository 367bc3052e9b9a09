#include "ForceLimit.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::force_limit_test
{
namespace
{
TEST(ForceLimit, NeverExceedsTheMaximum)
{
  test::Random random(11);
  ForceLimit limit(8.0);
  for (int n = 0; n < 100'000; ++n)
  {
    const Vector3 out =
        limit.Apply(n % 2 == 0 ? test::VectorOfAnyLength(random) : test::HostileVector(random));
    ASSERT_TRUE(out.allFinite());
    ASSERT_LE(out.norm(), 8.0);
  }
}

TEST(ForceLimit, KeepsTheDirection)
{
  test::Random random(12);
  ForceLimit limit(2.0);
  for (const double length : {2.0001, 10.0, 1e100, 1e300, 1.7e308})
  {
    for (int n = 0; n < 100; ++n)
    {
      const Vector3 direction = test::RandomDirection(random);
      const Vector3 out = limit.Apply(length * direction);
      EXPECT_TRUE(limit.IsLimiting());
      // Some roundings of components of at most 2.
      EXPECT_LE((out - 2.0 * direction).norm(), 1e-14);
    }
  }
}

TEST(ForceLimit, PassesAllowedForcesExactly)
{
  test::Random random(13);
  ForceLimit limit(1.0);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 force = 0.999 * test::RandomDirection(random);
    EXPECT_EQ(limit.Apply(force), force);
    EXPECT_FALSE(limit.IsLimiting());
  }
}

TEST(ForceLimit, IsZeroWithoutAMaximum)
{
  for (const double maximum : {0.0, -1.0, test::NotANumber})
  {
    EXPECT_EQ(ForceLimit(maximum).Apply(Vector3(1.0, 2.0, 3.0)), Vector3::Zero());
  }
}
} // namespace
} // namespace palpate::force_limit_test
