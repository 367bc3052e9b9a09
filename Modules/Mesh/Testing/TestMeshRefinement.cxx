#include "MeshRefinement.h"

#include "MeshShapes.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::mesh_refinement_test
{
namespace
{
using namespace palpate::test;

double LongestEdge(const IndexedMesh& mesh)
{
  double longest = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      longest = std::max(longest, (mesh.Points[t[k]] - mesh.Points[t[(k + 1) % 3]]).norm());
    }
  }
  return longest;
}

TEST(MeshRefinement, BoxKeepsVolumeAreaAndTopology)
{
  // Dyadic coordinates: midpoints, area and volume are exact.
  IndexedMesh mesh = Box({0, 0, 0}, {16, 4, 1});
  EXPECT_TRUE(SplitLongEdges(mesh, 1.0, 100'000));
  EXPECT_LE(LongestEdge(mesh), 1.0);
  const SurfaceTopology topology = DescribeTopology(mesh);
  EXPECT_TRUE(CheckClosedGenusZero(topology).IsOk());
  EXPECT_NEAR(topology.Volume, 64.0, 1e-12);
  EXPECT_NEAR(topology.Area, 2 * (64 + 16 + 4), 1e-12);
  EXPECT_EQ(topology.FlatTriangles, 0);
}

TEST(MeshRefinement, KeepsHandlesAndBoundaries)
{
  IndexedMesh torus = Torus(7, 5);
  EXPECT_TRUE(SplitLongEdges(torus, 0.5, 100'000));
  EXPECT_EQ(DescribeTopology(torus).Handles(), 1);
  IndexedMesh open = Box({0, 0, 0}, {1, 1, 1});
  open.Triangles.pop_back();
  EXPECT_TRUE(SplitLongEdges(open, 0.3, 100'000));
  EXPECT_EQ(DescribeTopology(open).Holes, 1);
}

TEST(MeshRefinement, ShortEdgesStayBitForBit)
{
  const IndexedMesh sphere = Sphere(6);
  IndexedMesh mesh = sphere;
  EXPECT_TRUE(SplitLongEdges(mesh, 2.0, 100'000));
  EXPECT_EQ(mesh.Points, sphere.Points);
  EXPECT_EQ(mesh.Triangles, sphere.Triangles);
}

TEST(MeshRefinement, StopsBeforeItExceedsLimit)
{
  IndexedMesh mesh = Box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(SplitLongEdges(mesh, 1e-6, 1000));
  EXPECT_LE(mesh.Triangles.size(), 1000U);
  EXPECT_TRUE(CheckClosedGenusZero(DescribeTopology(mesh)).IsOk());
  IndexedMesh none;
  EXPECT_TRUE(SplitLongEdges(none, 1.0, 0));
}
} // namespace
} // namespace palpate::mesh_refinement_test
