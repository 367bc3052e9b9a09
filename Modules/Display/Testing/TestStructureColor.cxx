#include "StructureColor.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::structure_color_test
{
namespace
{
TEST(StructureColor, KeepsColoursOfFiles)
{
  for (const std::array<double, 3>& color :
       {std::array<double, 3>{{1.0, 0.0, 0.0}}, {{0.15, 0.0, 0.33}}, {{0.4, 0.4, 0.4}}})
  {
    EXPECT_EQ(StructureColor(color, 3), color);
  }
}

// AAL's ten labels 21 to 30 are (0, 0, 0), 95 and 96 (8, 8, 8).
TEST(StructureColor, ReplacesBlackByDistinctBrightColours)
{
  for (const double grey : {0.0, 8.0 / 255.0})
  {
    for (int id = 1; id <= 300; ++id)
    {
      const auto color = StructureColor({{grey, grey, grey}}, id);
      EXPECT_GT(*std::max_element(color.begin(), color.end()), 0.4) << id;
      EXPECT_LE(*std::max_element(color.begin(), color.end()), 1.0) << id;
      EXPECT_EQ(color, StructureColor({{0.0, 0.0, 0.0}}, id)) << "determined by the id";
      for (int other = std::max(1, id - 20); other < id; ++other)
      {
        const auto near = StructureColor({{0.0, 0.0, 0.0}}, other);
        EXPECT_GT(std::hypot(color[0] - near[0], color[1] - near[1], color[2] - near[2]), 0.1)
            << id << ", " << other;
      }
    }
  }
}

TEST(StructureColor, TakesAnyId)
{
  EXPECT_EQ(StructureColor({}, 0), StructureColor({}, 1));
  EXPECT_EQ(StructureColor({}, -5), StructureColor({}, 1));
}
} // namespace
} // namespace palpate::structure_color_test
