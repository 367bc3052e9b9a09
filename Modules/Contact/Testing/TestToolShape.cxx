#include "ToolShape.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace palpate::tool_shape_test
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
// Of coordinates up to 10 after a few operations.
constexpr double Rounding = 1e-13;

TEST(ToolShape, PublishedShellIsTheVoxelNeighbours)
{
  const ToolShape tool = ToolShape::SpherePoints(2.5, 26);
  ASSERT_TRUE(tool.Check().IsOk());
  ASSERT_EQ(tool.Points().size(), 26u);
  std::map<int, int> neighbours; // how many coordinates differ from zero -> how many such points
  for (std::size_t i = 0; i < 26; ++i)
  {
    const Vector3& p = tool.Points()[i];
    EXPECT_NEAR(p.norm(), 2.5, Rounding);
    EXPECT_NEAR((tool.Normals()[i] + p / 2.5).norm(), 0.0, Rounding);
    ++neighbours[static_cast<int>((p.array().abs() > 0.1).count())];
  }
  EXPECT_EQ(neighbours, (std::map<int, int>{{1, 6}, {2, 12}, {3, 8}}));
}

TEST(ToolShape, ShellsCoverTheSphereEvenly)
{
  for (const int count : {4, 6, 26, 100, 400})
  {
    const ToolShape tool = ToolShape::SpherePoints(1.0, count);
    ASSERT_TRUE(tool.Check().IsOk());
    Vector3 sum = Vector3::Zero();
    for (const Vector3& p : tool.Points())
    {
      sum += p;
    }
    // The centroid of the smallest spirals is off by at most a third of the radius.
    EXPECT_LE(sum.norm() / count, count < 10 ? 0.34 : 0.03) << count;
    test::Random random(31);
    // A cap of n times the area per point, where n = 4 allows for its round shape.
    const double reach = std::acos(std::max(-1.0, 1.0 - 2.0 * 4.0 / count));
    for (int k = 0; k < 200; ++k)
    {
      const Vector3 u = test::RandomDirection(random);
      double nearest = M_PI;
      for (const Vector3& p : tool.Points())
      {
        nearest = std::min(nearest, std::acos(std::min(1.0, p.dot(u))));
      }
      EXPECT_LE(nearest, reach) << count;
    }
  }
}

TEST(ToolShape, CapsulePointsLieAtItsRadius)
{
  const ToolShape tool = ToolShape::Capsule(1.5, 6.0, 120);
  ASSERT_TRUE(tool.Check().IsOk());
  EXPECT_FALSE(tool.IsSphere());
  EXPECT_DOUBLE_EQ(tool.BoundingRadius(), 4.5);
  for (std::size_t i = 0; i < tool.Points().size(); ++i)
  {
    const Vector3& p = tool.Points()[i];
    const Vector3 axis(0.0, 0.0, std::min(3.0, std::max(-3.0, p[2])));
    EXPECT_NEAR((p - axis).norm(), 1.5, Rounding);
    EXPECT_NEAR((axis - p).normalized().dot(tool.Normals()[i]), 1.0, Rounding);
  }
}

TEST(ToolShape, EllipsoidNormalsAreItsGradient)
{
  const Vector3 axes(1.0, 2.0, 4.0);
  const ToolShape tool = ToolShape::Ellipsoid(axes, 90);
  ASSERT_TRUE(tool.Check().IsOk());
  EXPECT_DOUBLE_EQ(tool.BoundingRadius(), 4.0);
  for (std::size_t i = 0; i < tool.Points().size(); ++i)
  {
    const Vector3& p = tool.Points()[i];
    EXPECT_NEAR(p.cwiseQuotient(axes).norm(), 1.0, Rounding);
    const Vector3 gradient = p.cwiseQuotient(axes.cwiseProduct(axes));
    EXPECT_NEAR(tool.Normals()[i].dot(gradient.normalized()), -1.0, Rounding);
  }
}

TEST(ToolShape, NormalisesNormalsAndFindsTheBoundingRadius)
{
  const std::vector<Vector3> corners{{3, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}};
  const std::vector<Vector3> inward{{-2, 0, 0}, {0, -1, 0}, {0, 0, -7}, {1, 1, 1}};
  const ToolShape tool = ToolShape::FromSurfacePoints(corners, inward);
  ASSERT_TRUE(tool.Check().IsOk());
  EXPECT_DOUBLE_EQ(tool.BoundingRadius(), 3.0);
  EXPECT_NEAR(tool.Normals()[3].dot(Vector3::Ones().normalized()), 1.0, Rounding);
}

TEST(ToolShape, RejectsInvalidTools)
{
  const std::vector<Vector3> four(4, Vector3::UnitX());
  std::vector<Vector3> broken = four;
  broken[2] = Vector3::Zero();
  for (const ToolShape& tool :
       {ToolShape::Sphere(-1.0), ToolShape::Sphere(NotANumber), ToolShape::SpherePoints(1.0, 3),
        ToolShape::SpherePoints(1.0, 5000), ToolShape::SpherePoints(NotANumber, 26),
        ToolShape::Capsule(-1.0, 2.0, 50), ToolShape::Capsule(1.0, -2.0, 50),
        ToolShape::Ellipsoid({1.0, 0.0, 1.0}, 50), ToolShape::Ellipsoid({1.0, -1.0, 1.0}, 50),
        ToolShape::FromSurfacePoints(four, {}), ToolShape::FromSurfacePoints(four, broken),
        ToolShape::FromSurfacePoints({}, {})})
  {
    EXPECT_FALSE(tool.Check().IsOk());
  }
  EXPECT_TRUE(ToolShape::Sphere(0.0).Check().IsOk());
}
} // namespace
} // namespace palpate::tool_shape_test
