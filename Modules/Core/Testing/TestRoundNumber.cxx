#include "RoundNumber.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::round_number_test
{
namespace
{
TEST(RoundNumber, RoundsUpToTheNextMantissa)
{
  EXPECT_EQ(RoundNumberAbove(0.011), 0.02);
  EXPECT_EQ(RoundNumberAbove(3.0), 5.0);
  EXPECT_EQ(RoundNumberAbove(5.1), 10.0);
  EXPECT_EQ(RoundNumberAbove(1.2, {1.0, 1.5, 2.0, 3.0}), 1.5);
  EXPECT_EQ(RoundNumberAbove(310.0, {1.0, 1.5, 2.0, 3.0}), 1000.0);
}

TEST(RoundNumber, KeepsRoundNumbers)
{
  for (int power = -9; power <= 9; ++power)
  {
    for (const double mantissa : {1.0, 2.0, 5.0})
    {
      const double size = mantissa * std::pow(10.0, power);
      EXPECT_NEAR(RoundNumberAbove(size) / size, 1.0, 1e-12); // rounding of the power
    }
  }
}

TEST(RoundNumber, IsOneForZeroAndNonFiniteSizes)
{
  EXPECT_EQ(RoundNumberAbove(0.0), 1.0);
  EXPECT_EQ(RoundNumberAbove(-2.0), 1.0);
  EXPECT_EQ(RoundNumberAbove(std::nan("")), 1.0);
  EXPECT_EQ(RoundNumberAbove(INFINITY), 1.0);
}
} // namespace
} // namespace palpate::round_number_test
