#include "MeshCrossings.h"

#include "MeshShapes.h"
#include "RandomShapes.h"
#include "RationalTriangles.h"
#include "TriangleCrossing.h"
#include "TriangleTree.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace palpate::mesh_crossings_test
{
namespace
{
std::int64_t CrossingsOf(const IndexedMesh& mesh)
{
  MeshCrossings found;
  EXPECT_TRUE(FindMeshCrossings(mesh, {}, found).IsOk());
  EXPECT_TRUE(found.IsComplete);
  return found.Count;
}

// Triangles between random points of a small integer grid: most pairs are degenerate in some way.
IndexedMesh Soup(test::Random& random, int pointCount, int triangleCount, int size)
{
  IndexedMesh mesh;
  for (int i = 0; i < pointCount; ++i)
  {
    const auto coordinate = [&] { return static_cast<double>(random() % size); };
    const double x = coordinate();
    const double y = coordinate();
    mesh.Points.emplace_back(x, y, coordinate());
  }
  while (static_cast<int>(mesh.Triangles.size()) < triangleCount)
  {
    const auto point = [&] { return static_cast<int>(random() % pointCount); };
    const int a = point();
    const int b = point();
    const int c = point();
    if (!AreCollinear(mesh.Points[a], mesh.Points[b], mesh.Points[c]))
    {
      mesh.Triangles.push_back({a, b, c});
    }
  }
  return mesh;
}

// Exact: multiples of 1/4 at some distance from the origin.
IndexedMesh Moved(IndexedMesh mesh)
{
  for (Vector3& p : mesh.Points)
  {
    p = Vector3(1 << 20, -3, 1e9) + 0.25 * p;
  }
  return mesh;
}

TEST(TrianglesCross, AgreesWithRationalClippingOnDegenerateSoup)
{
  test::Random random(41);
  for (const int size : {2, 3, 5, 12})
  {
    const IndexedMesh mesh = Soup(random, 40, 110, size);
    const IndexedMesh moved = Moved(mesh);
    int crossing = 0;
    for (int i = 0; i < 110; ++i)
    {
      for (int j = i + 1; j < 110; ++j)
      {
        const bool expected = test::TrianglesCrossByClipping(mesh, i, j);
        crossing += expected ? 1 : 0;
        ASSERT_EQ(TrianglesCross(mesh, i, j), expected) << size << " " << i << " " << j;
        ASSERT_EQ(TrianglesCross(mesh, j, i), expected) << size << " " << i << " " << j;
        ASSERT_EQ(TrianglesCross(moved, i, j), expected) << size << " " << i << " " << j;
      }
    }
    EXPECT_GT(crossing, 300);
    EXPECT_LT(crossing, 5900);
  }
}

TEST(MeshCrossings, EqualBruteForceOverAllPairs)
{
  test::Random random(42);
  for (const int triangles : {1, 4, 5, 17, 300})
  {
    const IndexedMesh mesh = Soup(random, 200, triangles, 40);
    std::set<std::pair<int, int>> expected;
    for (int i = 0; i < triangles; ++i)
    {
      for (int j = i + 1; j < triangles; ++j)
      {
        if (TrianglesCross(mesh, i, j))
        {
          expected.insert({i, j});
        }
      }
    }
    MeshCrossings found;
    ASSERT_TRUE(FindMeshCrossings(mesh, {100'000, 1'000'000}, found).IsOk());
    std::set<std::pair<int, int>> pairs;
    for (const MeshCrossing& pair : found.Pairs)
    {
      pairs.insert({pair.First, pair.Second});
    }
    EXPECT_EQ(found.Count, static_cast<std::int64_t>(expected.size()));
    EXPECT_EQ(pairs, expected);
  }
}

TEST(MeshCrossings, ClosedSmoothSurfacesHaveNone)
{
  EXPECT_EQ(CrossingsOf(test::Sphere(20)), 0);
  EXPECT_EQ(CrossingsOf(test::Torus(60, 30)), 0);
  EXPECT_EQ(CrossingsOf(test::Lobed(20)), 0);
  EXPECT_EQ(CrossingsOf(test::Box({0, 0, 0}, {1, 2, 3})), 0);
}

TEST(MeshCrossings, CoplanarNeighboursAreNone)
{
  IndexedMesh plane;
  constexpr int Side = 12;
  for (int i = 0; i < Side * Side; ++i)
  {
    plane.Points.emplace_back(0.1 * (i % Side), 0.3, 0.1 * (i / Side)); // rounded differently
    if (i % Side + 1 < Side && i / Side + 1 < Side)
    {
      plane.Triangles.push_back({i, i + 1, i + Side});
      plane.Triangles.push_back({i + 1, i + Side + 1, i + Side});
    }
  }
  EXPECT_EQ(CrossingsOf(plane), 0);
  std::swap(plane.Points[5 * Side + 5], plane.Points[5 * Side + 6]);
  EXPECT_GT(CrossingsOf(plane), 0);
}

TEST(MeshCrossings, FindFoldOfTwoNeighbours)
{
  IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.25, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(CrossingsOf(mesh), 1);
  mesh.Points[3][2] = 1e-60; // not quite
  EXPECT_EQ(CrossingsOf(mesh), 0);
  mesh.Points[3] = {0.5, -0.25, 0.0};
  EXPECT_EQ(CrossingsOf(mesh), 0);
}

TEST(MeshCrossings, FindTetrahedraThatTouchInOnePoint)
{
  // Three triangles of each around the point, by different indices.
  EXPECT_EQ(CrossingsOf(
                test::Join(test::Tetrahedron({1, 1, 1}, 1.0), test::Tetrahedron({1, 1, 1}, -1.0))),
            9);
  EXPECT_EQ(CrossingsOf(test::Join(test::Tetrahedron({1, 1, 1}, 1.0),
                                   test::Tetrahedron({std::nextafter(1.0, 0.0), 1, 1}, -1.0))),
            0);
}

TEST(MeshCrossings, FindCoplanarOverlapAndContainedTriangle)
{
  const IndexedMesh large{{{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}, {{0, 1, 2}}};
  EXPECT_EQ(CrossingsOf(test::Join(large, {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, {{0, 1, 2}}})), 1);
  EXPECT_EQ(CrossingsOf(test::Join(large, {{{5, 5, 1}, {6, 5, 1}, {5, 6, 1}}, {{0, 1, 2}}})), 0);
  EXPECT_EQ(CrossingsOf(test::Join(large, {{{4, 4, 1}, {9, 9, 1}, {8, 9, 1}}, {{0, 1, 2}}})), 1);
}

TEST(MeshCrossings, OfTwoSpheresLieOnTheirCommonCircle)
{
  const IndexedMesh mesh =
      test::Join(test::Sphere(15, 1.0, {-0.6, 0, 0}), test::Sphere(15, 1.0, {0.6, 0.001, 0}));
  MeshCrossings found;
  ASSERT_TRUE(FindMeshCrossings(mesh, {1000, 1'000'000}, found).IsOk());
  EXPECT_GT(found.Count, 80);
  ASSERT_EQ(found.Count, static_cast<std::int64_t>(found.Pairs.size()));
  for (const MeshCrossing& pair : found.Pairs)
  {
    EXPECT_LT(pair.First, 4500);
    EXPECT_GE(pair.Second, 4500);
    // The boxes of triangles with edges of some 0.08.
    EXPECT_NEAR(pair.Place[0], 0.0, 0.1);
    EXPECT_NEAR(pair.Place.tail<2>().norm(), 0.8, 0.1);
  }
}

TEST(MeshCrossings, EndAtLimits)
{
  const IndexedMesh mesh = test::Join(test::Sphere(9), test::Sphere(9, 1.0, {0.5, 0, 0}));
  MeshCrossings found;
  ASSERT_TRUE(FindMeshCrossings(mesh, {3, 10}, found).IsOk());
  EXPECT_EQ(found.Pairs.size(), 3U);
  EXPECT_EQ(found.Count, 10);
  EXPECT_FALSE(found.IsComplete);
}

TEST(MeshCrossings, CountFlatTrianglesApart)
{
  IndexedMesh mesh = test::Sphere(3);
  mesh.Triangles.push_back({0, 0, 5});
  MeshCrossings found;
  ASSERT_TRUE(FindMeshCrossings(mesh, {}, found).IsOk());
  EXPECT_EQ(found.FlatTriangles, 1);
  EXPECT_EQ(found.Count, 0);
}

TEST(MeshCrossings, RoundTinyCoordinatesToZero)
{
  IndexedMesh mesh = test::Tetrahedron({0, 0, 0}, 1.0);
  mesh.Points[0] = {1e-200, 1e-300, 5e-324};
  EXPECT_EQ(CrossingsOf(mesh), 0);
}

TEST(MeshCrossings, RejectBadInput)
{
  MeshCrossings found;
  EXPECT_FALSE(FindMeshCrossings({}, {}, found).IsOk());
  IndexedMesh mesh = test::Sphere(2);
  mesh.Triangles[4][2] = 42;
  EXPECT_FALSE(FindMeshCrossings(mesh, {}, found).IsOk());
  mesh.Triangles[4][2] = -1;
  EXPECT_FALSE(FindMeshCrossings(mesh, {}, found).IsOk());
  mesh = test::Sphere(2);
  mesh.Points[9][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(FindMeshCrossings(mesh, {}, found).IsOk());
  mesh.Points[9][0] = 1e31;
  EXPECT_FALSE(FindMeshCrossings(mesh, {}, found).IsOk());
}

TEST(TriangleTree, NodesContainTheirTrianglesOnce)
{
  const IndexedMesh mesh = test::Lobed(10);
  TriangleTree tree;
  ASSERT_TRUE(TriangleTree::Make(mesh, tree).IsOk());
  std::set<int> seen;
  for (const TriangleTree::Node& node : tree.Nodes())
  {
    for (int i = node.Second; i < node.Second + node.Count; ++i)
    {
      EXPECT_TRUE(seen.insert(tree.Order()[i]).second);
      for (const int corner : mesh.Triangles[tree.Order()[i]])
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_LE(node.Box.Low[axis], mesh.Points[corner][axis]);
          EXPECT_GE(node.Box.High[axis], mesh.Points[corner][axis]);
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), mesh.Triangles.size());
}
} // namespace
} // namespace palpate::mesh_crossings_test
