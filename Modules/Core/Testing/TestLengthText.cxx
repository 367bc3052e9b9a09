#include "LengthText.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::length_text_test
{
namespace
{
TEST(LengthText, UnitsResolveTheSame)
{
  EXPECT_EQ(LengthText(LengthUnit::Millimeter, 12.34, 1), "12.3 mm");
  EXPECT_EQ(LengthText(LengthUnit::Centimeter, 12.34, 1), "1.23 cm");
  EXPECT_EQ(LengthText(LengthUnit::Centimeter, -0.04, 1), "0.00 cm");
  EXPECT_EQ(LengthText(LengthUnit::Centimeter, 50.0, 0), "5.0 cm");
}
} // namespace
} // namespace palpate::length_text_test
