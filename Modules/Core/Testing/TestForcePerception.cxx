#include "ForcePerception.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::force_perception_test
{
namespace
{
TEST(ForcePerception, FollowsWebersLawFromHalfANewton)
{
  for (const double force : {0.5, 1.0, 2.5, 10.0})
  {
    EXPECT_NEAR(ForcePerception::JustNoticeable(force), 0.07 * force, 1e-15 * force);
    EXPECT_EQ(ForcePerception::JustNoticeable(-force), ForcePerception::JustNoticeable(force));
  }
}

TEST(ForcePerception, KeepsFloorBelowHalfANewton)
{
  for (const double force : {0.0, 1e-300, 0.1, 0.499})
  {
    EXPECT_NEAR(ForcePerception::JustNoticeable(force), 0.035, 1e-17);
  }
}

TEST(ForcePerception, ContrastCountsJndsOfReference)
{
  EXPECT_EQ(ForcePerception::Contrast(1.0, 1.0), 0.0);
  EXPECT_NEAR(ForcePerception::Contrast(1.07, 1.0), 1.0, 1e-12);
  EXPECT_NEAR(ForcePerception::Contrast(0.86, 1.0), -2.0, 1e-12);
  EXPECT_NEAR(ForcePerception::Contrast(0.135, 0.1), 1.0, 1e-12); // floor
}

TEST(ForcePerception, PassesNanOn)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(ForcePerception::JustNoticeable(nan)));
  EXPECT_TRUE(std::isnan(ForcePerception::Contrast(nan, 1.0)));
  EXPECT_TRUE(std::isnan(ForcePerception::Contrast(1.0, nan)));
}
} // namespace
} // namespace palpate::force_perception_test
