#include "ConvexHull.h"

#include "ExactSign.h"
#include "MeshShapes.h"
#include "SurfaceTopology.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::convex_hull_test
{
namespace
{
// A closed surface none of whose faces sees a point, and whose corners are points.
void ExpectHullOf(const std::vector<Vector3>& points, const IndexedMesh& hull)
{
  const SurfaceTopology topology = DescribeTopology(hull);
  EXPECT_TRUE(topology.IsConsistent());
  EXPECT_EQ(topology.Handles(), 0);
  EXPECT_GT(topology.Volume, 0.0);
  for (const auto& [a, b, c] : hull.Triangles)
  {
    const exact::Plane plane(hull.Points[a], hull.Points[b], hull.Points[c]);
    for (const Vector3& point : points)
    {
      ASSERT_LE(plane.SideOf(point), 0);
    }
  }
}

TEST(ConvexHull, NoPointIsOutside)
{
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int count = 4; count < 400; count = count * 3 / 2)
  {
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i)
    {
      points.emplace_back(normal(random), 3.0 * normal(random), 0.1 * normal(random));
    }
    ExpectHullOf(points, ConvexHullOf(points));
  }
}

TEST(ConvexHull, OfALatticeIsItsBox)
{
  std::vector<Vector3> points;
  for (int i = 0; i < 8 * 6 * 5; ++i)
  {
    points.emplace_back(0.3 * (i % 8), 0.7 * (i / 8 % 6), 0.1 * (i / 48));
  }
  const IndexedMesh hull = ConvexHullOf(points);
  ExpectHullOf(points, hull);
  EXPECT_NEAR(DescribeTopology(hull).Volume, 2.1 * 3.5 * 0.4, 1e-12);
}

TEST(ConvexHull, FillsDents)
{
  const IndexedMesh torus = test::Torus(60, 30);
  const IndexedMesh hull = ConvexHullOf(torus.Points);
  ExpectHullOf(torus.Points, hull);
  // A disc of radius 3 and height 2, and the outer half of the torus around it (Pappus); polygons
  // of 60 and 30 sides have 1.8 % less.
  const double whole = 18.0 * M_PI + M_PI * M_PI * (3.0 + 4.0 / (3.0 * M_PI));
  EXPECT_NEAR(DescribeTopology(hull).Volume / whole, 1.0 - 0.012, 0.008);
}

TEST(ConvexHull, OfAPlaneHasNoTriangles)
{
  EXPECT_TRUE(ConvexHullOf({}).Triangles.empty());
  EXPECT_TRUE(
      ConvexHullOf({Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()}).Triangles.empty());
  std::vector<Vector3> flat;
  for (int i = 0; i < 30; ++i)
  {
    flat.emplace_back(i % 5, i / 5, i % 5 + 2.0 * (i / 5));
  }
  EXPECT_TRUE(ConvexHullOf(flat).Triangles.empty());
  EXPECT_TRUE(ConvexHullOf(std::vector<Vector3>(9, Vector3::Ones())).Triangles.empty());
}
} // namespace
} // namespace palpate::convex_hull_test
