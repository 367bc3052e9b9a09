#include "CutTool.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::cut_tool_test
{
namespace
{
// A sphere of 2 mm as samples, 0.25 mm apart.
CutTool SampledSphere(double radius)
{
  const FieldGrid grid({25, 25, 25}, Vector3::Constant(-3.0), Vector3::Constant(0.25),
                       Matrix3::Identity());
  std::vector<double> distances;
  for (int k = 0; k < 25; ++k)
  {
    for (int j = 0; j < 25; ++j)
    {
      for (int i = 0; i < 25; ++i)
      {
        distances.push_back(grid.PointWorld(Vector3(i, j, k)).norm() - radius);
      }
    }
  }
  return CutTool::Surface(grid, distances);
}

TEST(CutTool, SphereDistanceIsExact)
{
  const CutTool tool = CutTool::Sphere(1.5);
  EXPECT_DOUBLE_EQ(tool.Distance(Vector3(3.0, 0.0, 4.0)), 3.5);
  EXPECT_DOUBLE_EQ(tool.Distance(Vector3::Zero()), -1.5);
  EXPECT_DOUBLE_EQ(tool.BoundingRadius(), 1.5);
}

TEST(CutTool, CylinderDistanceIsExactAtSideEndAndEdge)
{
  const CutTool tool = CutTool::Cylinder(1.0, 6.0);
  EXPECT_DOUBLE_EQ(tool.Distance(Vector3(3.0, 0.0, 1.0)), 2.0);
  EXPECT_DOUBLE_EQ(tool.Distance(Vector3(0.0, 0.5, 5.0)), 2.0);
  EXPECT_DOUBLE_EQ(tool.Distance(Vector3(4.0, 0.0, 7.0)), 5.0); // from the edge, 3 and 4 mm off
  EXPECT_DOUBLE_EQ(tool.Distance(Vector3(0.25, 0.0, 0.0)), -0.75);
  EXPECT_NEAR(tool.Distance(Vector3(0.0, 0.0, -2.9)), -0.1, 1e-15);
}

TEST(CutTool, SampledSurfaceInterpolatesItsSamples)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  const CutTool tool = SampledSphere(2.0);
  ASSERT_TRUE(tool.Check().IsOk());
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Vector3 point(place(random), place(random), place(random));
    // Between nodes a distance curves by at most its second derivative, 1 / |p|.
    const double bend = 0.25 * 0.25 * 3.0 / 8.0 / std::max(point.norm(), 0.25);
    EXPECT_NEAR(tool.Distance(point), point.norm() - 2.0, bend);
  }
}

TEST(CutTool, SampledDistanceGrowsBeyondItsGrid)
{
  const CutTool tool = SampledSphere(2.0);
  EXPECT_NEAR(tool.Distance(Vector3(8.0, 0.0, 0.0)), 6.0, 1e-12);
  EXPECT_GE(tool.Distance(Vector3(5.0, 5.0, 5.0)), std::sqrt(75.0) - 2.0 - 1e-12);
}

TEST(CutTool, BoundingRadiusContainsTheInside)
{
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  for (const CutTool& tool :
       {CutTool::Sphere(2.0), CutTool::Cylinder(1.0, 8.0), SampledSphere(2.0)})
  {
    for (int trial = 0; trial < 2000; ++trial)
    {
      const Vector3 point(place(random), place(random), place(random));
      EXPECT_TRUE(tool.Distance(point) > 0.0 || point.norm() <= tool.BoundingRadius());
    }
  }
}

TEST(CutTool, RejectsInvalidTools)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double length : {0.0, -1.0, nan, static_cast<double>(INFINITY)})
  {
    EXPECT_FALSE(CutTool::Sphere(length).Check().IsOk()) << length;
    EXPECT_FALSE(CutTool::Cylinder(length, 1.0).Check().IsOk()) << length;
    EXPECT_FALSE(CutTool::Cylinder(1.0, length).Check().IsOk()) << length;
  }
  EXPECT_FALSE(SampledSphere(3.5).Check().IsOk()); // cut off by its grid
  EXPECT_FALSE(SampledSphere(-1.0).Check().IsOk());
  EXPECT_FALSE(SampledSphere(nan).Check().IsOk());
  const FieldGrid grid({3, 3, 3}, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity());
  EXPECT_FALSE(CutTool::Surface(grid, std::vector<double>(26, 1.0)).Check().IsOk());
}
} // namespace
} // namespace palpate::cut_tool_test
