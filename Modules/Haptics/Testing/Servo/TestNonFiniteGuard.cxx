#include "NonFiniteGuard.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::non_finite_guard_test
{
namespace
{
TEST(NonFiniteGuard, BlocksExactlyImplausibleForces)
{
  test::Random random(31);
  NonFiniteGuard guard;
  for (int n = 0; n < 10'000; ++n)
  {
    const Vector3 force = test::HostileVector(random);
    const bool isSane = force.allFinite() && force.cwiseAbs().maxCoeff() <= 1e6;
    guard.Reset();
    EXPECT_EQ(guard.Apply(force), isSane ? force : Vector3(Vector3::Zero()));
    EXPECT_EQ(guard.HasTripped(), !isSane);
  }
}

TEST(NonFiniteGuard, RemembersThatItTripped)
{
  NonFiniteGuard guard;
  static_cast<void>(guard.Apply({0.0, test::NotANumber, 0.0}));
  static_cast<void>(guard.Apply(Vector3::UnitX()));
  EXPECT_TRUE(guard.HasTripped());
}
} // namespace
} // namespace palpate::non_finite_guard_test
