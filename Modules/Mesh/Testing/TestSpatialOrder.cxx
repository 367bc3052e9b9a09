#include "SpatialOrder.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace palpate::spatial_order_test
{
namespace
{
TEST(SpatialOrder, BringsClosePointsTogether)
{
  test::Random random(75);
  std::uniform_real_distribution<double> coordinate(-40.0, 40.0);
  std::vector<Vector3> points;
  for (int i = 0; i < 4000; ++i)
  {
    points.emplace_back(coordinate(random), 0.1 * coordinate(random), coordinate(random));
  }
  const std::vector<int> order = SpatialOrder(points);
  double along = 0.0;
  double before = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    along += (points[order[i]] - points[order[i - 1]]).norm();
    before += (points[i] - points[i - 1]).norm();
  }
  EXPECT_LT(along, 0.1 * before); // 4,000 points fill 32 x 32 x 4 cells
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
}

TEST(SpatialOrder, TakesNoneOneAndEqualPoints)
{
  EXPECT_TRUE(SpatialOrder({}).empty());
  EXPECT_EQ(SpatialOrder({Vector3(1e9, 0.0, -1e9)}), std::vector<int>{0});
  EXPECT_EQ(SpatialOrder({Vector3::Ones(), Vector3::Ones()}), (std::vector<int>{0, 1}));
}
} // namespace
} // namespace palpate::spatial_order_test
