#include "SphericalTriangle.h"

#include "RandomShapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::spherical_triangle_test
{
namespace
{
using test::Random;

// Whether a direction is on the inner side of the three planes, up to rounding.
bool Holds(const SphericalTriangle& triangle, const Vector3& u)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3 normal = triangle.Corners[i].cross(triangle.Corners[(i + 1) % 3]);
    if (!(normal.dot(u) >= -1e-15))
    {
      return false;
    }
  }
  return true;
}

Vector3 RandomInside(const SphericalTriangle& triangle, Random& random)
{
  std::exponential_distribution<double> part;
  return (part(random) * triangle.Corners[0] + part(random) * triangle.Corners[1] +
          part(random) * triangle.Corners[2])
      .normalized();
}

template <typename Triangles>
bool AnyHolds(const Triangles& triangles, const Vector3& u)
{
  return std::any_of(triangles.begin(), triangles.end(),
                     [&u](const SphericalTriangle& triangle) { return Holds(triangle, u); });
}

TEST(SphericalTriangle, IcosahedronCoversSphere)
{
  Random random(411);
  const std::vector<SphericalTriangle> faces = SphericalTriangle::Icosahedron();
  EXPECT_EQ(faces.size(), 20U);
  std::vector<Vector3> directions = test::RandomDirections(random, 500);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}});
  for (const Vector3& u : directions)
  {
    EXPECT_TRUE(AnyHolds(faces, u));
  }
}

TEST(SphericalTriangle, PartsCoverWhole)
{
  Random random(412);
  for (SphericalTriangle triangle : SphericalTriangle::Icosahedron())
  {
    for (int depth = 0; depth < 12; ++depth)
    {
      const std::array<SphericalTriangle, 4> parts = triangle.Split();
      for (int k = 0; k < 20; ++k)
      {
        EXPECT_TRUE(AnyHolds(parts, RandomInside(triangle, random))) << depth;
      }
      triangle = parts[static_cast<std::size_t>(depth) % 4];
    }
  }
}

TEST(SphericalTriangle, CapTightlyContainsTriangle)
{
  Random random(413);
  for (SphericalTriangle triangle : SphericalTriangle::Icosahedron())
  {
    for (int depth = 0; depth < 25; ++depth) // down to 1e-8 rad
    {
      const SphericalCap cap = triangle.Cap();
      double largest = 0.0;
      for (const Vector3& corner : triangle.Corners)
      {
        largest = std::max(largest, 2.0 * std::asin(0.5 * (corner - cap.Center).norm()));
      }
      EXPECT_LE(largest, cap.Radius);
      EXPECT_GE(largest, cap.Radius - 3e-12 * cap.Radius - 3e-14); // the documented margin
      for (int k = 0; k < 10; ++k)
      {
        EXPECT_LE((RandomInside(triangle, random) - cap.Center).norm(), cap.Radius);
      }
      triangle = triangle.Split()[static_cast<std::size_t>(depth) % 4];
    }
  }
}

TEST(SphericalTriangle, SplitHalvesCap)
{
  SphericalTriangle triangle = SphericalTriangle::Icosahedron().front();
  for (int depth = 0; depth < 10; ++depth)
  {
    const double before = triangle.Cap().Radius;
    for (const SphericalTriangle& part : triangle.Split())
    {
      EXPECT_LE(part.Cap().Radius,
                0.58 * before); // 0.5 on a plane; 0.56 at an icosahedron face's centre
    }
    triangle = triangle.Split()[3];
  }
}
} // namespace
} // namespace palpate::spherical_triangle_test
