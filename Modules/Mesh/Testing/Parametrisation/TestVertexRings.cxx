#include "MeshSimplification.h"
#include "VertexRings.h"

#include "ClosedMeshes.h"

#include <gtest/gtest.h>
#include <set>

namespace palpate::vertex_rings_test
{
namespace
{
using test::Random;

VertexRings RingsOf(const IndexedMesh& mesh)
{
  VertexRings rings;
  const Status status = VertexRings::From(mesh, rings);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return rings;
}

// Each as its least corner first, in order.
std::set<std::array<int, 3>> TrianglesOf(const VertexRings& rings)
{
  std::set<std::array<int, 3>> triangles;
  for (int v = 0; v < rings.Size(); ++v)
  {
    const Ring ring = rings.Of(v);
    for (int i = 0; i < ring.Count; ++i)
    {
      std::array<int, 3> t = {v, ring[i], ring[(i + 1) % ring.Count]};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      triangles.insert(t);
    }
  }
  return triangles;
}

std::vector<MappedVertex> VerticesOf(const IndexedMesh& mesh)
{
  std::vector<MappedVertex> vertices;
  for (const Vector3& point : mesh.Points)
  {
    vertices.push_back({point, Vector3::Zero()});
  }
  return vertices;
}

TEST(VertexRings, RunCounterClockwiseThroughEveryTriangle)
{
  const IndexedMesh mesh = test::SphereMesh(3);
  std::set<std::array<int, 3>> expected;
  for (std::array<int, 3> t : mesh.Triangles)
  {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    expected.insert(t);
  }
  EXPECT_EQ(TrianglesOf(RingsOf(mesh)), expected);
}

TEST(VertexRings, EveryCollapseLeavesATriangulation)
{
  Random random(1);
  const IndexedMesh mesh = test::RandomStarMesh(random, 3);
  const VertexRings start = RingsOf(mesh);
  for (int v = 0; v < start.Size(); ++v)
  {
    for (const int target : start.Of(v))
    {
      VertexRings rings = start;
      if (rings.CanCollapse(v, target))
      {
        rings.Collapse(v, target);
        EXPECT_EQ(TrianglesOf(rings).size(), mesh.Triangles.size() - 2);
        EXPECT_EQ(rings.Of(v).Count, 0);
      }
    }
  }
}

TEST(VertexRings, SplitsRestoreWhatCollapsesRemoved)
{
  Random random(2);
  for (const IndexedMesh& mesh :
       {test::RandomStarMesh(random, 6), test::Bipyramid(40), test::BentMesh(5, 4.0, 3.0)})
  {
    VertexRings rings = RingsOf(mesh);
    const std::set<std::array<int, 3>> expected = TrianglesOf(rings);
    MeshSimplification simplification;
    ASSERT_TRUE(Simplify(VerticesOf(mesh), {}, {}, rings, simplification));
    EXPECT_EQ(TrianglesOf(rings).size(), 4U);
    for (std::size_t i = simplification.Removals.size(); i > 0; --i)
    {
      const MeshSimplification::Removal& removal = simplification.Removals[i - 1];
      rings.Split(removal.Vertex, simplification.RingOf(removal), removal.Count);
    }
    EXPECT_EQ(TrianglesOf(rings), expected);
  }
}

// Without the penalty of changes, one equator vertex would absorb the others in turn.
TEST(MeshSimplification, ThinsARegularMeshEvenly)
{
  const IndexedMesh mesh = test::Bipyramid(64);
  VertexRings rings = RingsOf(mesh);
  MeshSimplification simplification;
  ASSERT_TRUE(Simplify(VerticesOf(mesh), {}, {}, rings, simplification));
  std::vector<bool> isRemoved(66, false);
  for (std::size_t i = 0; i < 32; ++i)
  {
    isRemoved[static_cast<std::size_t>(simplification.Removals[i].Vertex)] = true;
  }
  int longest = 0;
  int run = 0;
  for (std::size_t i = 2; i < 2 * 64; ++i)
  {
    run = isRemoved[2 + (i - 2) % 64] ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  EXPECT_LE(longest, 2);
}

TEST(MeshSimplification, RemovesNoVertexWithALargeRing)
{
  Random random(3);
  const IndexedMesh mesh = test::RandomStarMesh(random, 8);
  VertexRings rings = RingsOf(mesh);
  MeshSimplification simplification;
  ASSERT_TRUE(Simplify(VerticesOf(mesh), {}, {}, rings, simplification));
  EXPECT_EQ(simplification.Removals.size(), mesh.Points.size() - 4);
  for (const MeshSimplification::Removal& removal : simplification.Removals)
  {
    EXPECT_GE(removal.Count, 3);
    EXPECT_LE(removal.Count, MeshSimplification::LargestRing);
  }
}
} // namespace
} // namespace palpate::vertex_rings_test
