#include "SurfaceTopology.h"

#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::surface_topology_test
{
namespace
{
std::string FaultOf(const IndexedMesh& mesh)
{
  return CheckClosedGenusZero(DescribeTopology(mesh)).Message();
}

TEST(SurfaceTopology, DescribesSphere)
{
  const SurfaceTopology topology = DescribeTopology(test::Sphere(8, 2.0, {100, -50, 7}));
  EXPECT_EQ(topology.Points, 642);
  EXPECT_EQ(topology.Triangles, 1280);
  EXPECT_EQ(topology.Edges, 1920);
  EXPECT_EQ(topology.EulerCharacteristic, 2);
  EXPECT_EQ(topology.Handles(), 0);
  EXPECT_EQ(topology.Parts, 1);
  EXPECT_TRUE(topology.IsOrientable);
  EXPECT_EQ(FaultOf(test::Sphere(8)), "");
  // Inscribed with edges of some 0.28: the defects are of the order of the edge's square.
  EXPECT_NEAR(topology.Volume, 32.0 / 3.0 * M_PI, 0.9);
  EXPECT_NEAR(topology.Area, 16.0 * M_PI, 0.9);
}

TEST(SurfaceTopology, MeasuresBoxExactlyFarFromOrigin)
{
  const Vector3 low(1e6, -2e6, 3e6);
  const SurfaceTopology topology = DescribeTopology(test::Box(low, low + Vector3(2, 3, 4)));
  EXPECT_EQ(topology.Volume, 24.0);
  EXPECT_EQ(topology.Area, 52.0);
}

TEST(SurfaceTopology, CountsHandles)
{
  EXPECT_EQ(FaultOf(test::Torus(12, 7)), "The surface has 1 handle.");
  const SurfaceTopology two =
      DescribeTopology(test::Join(test::Torus(12, 7), test::Torus(9, 5, 100.0, 1.0)));
  EXPECT_EQ(two.Handles(), 2);
  EXPECT_EQ(CheckClosedGenusZero(two).Message(), "The surface has 2 separate parts.");
}

TEST(SurfaceTopology, CountsHoles)
{
  IndexedMesh mesh = test::Sphere(6);
  for (const std::size_t t : {700U, 350U, 10U})
  {
    mesh.Triangles.erase(mesh.Triangles.begin() + t);
  }
  const SurfaceTopology topology = DescribeTopology(mesh);
  EXPECT_EQ(topology.BoundaryEdges, 9);
  EXPECT_EQ(topology.Holes, 3);
  EXPECT_EQ(FaultOf(mesh), "The surface has 3 holes.");
}

TEST(SurfaceTopology, CountsHolesOfOpenBox)
{
  IndexedMesh box = test::Box({0, 0, 0}, {1, 1, 1});
  box.Triangles.resize(10);
  EXPECT_EQ(DescribeTopology(box).BoundaryEdges, 4);
  EXPECT_EQ(FaultOf(box), "The surface has 1 hole.");
}

TEST(SurfaceTopology, SingleTriangleIsAHole)
{
  EXPECT_EQ(FaultOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), "The surface has 1 hole.");
}

TEST(SurfaceTopology, NamesNonManifoldEdges)
{
  IndexedMesh mesh = test::Sphere(4);
  const auto t = mesh.Triangles.front();
  mesh.Points.emplace_back(5, 5, 5);
  mesh.Triangles.push_back({t[0], t[1], static_cast<int>(mesh.Points.size()) - 1});
  EXPECT_EQ(DescribeTopology(mesh).NonManifoldEdges, 1);
  EXPECT_EQ(DescribeTopology(mesh).Parts, 1);
  EXPECT_EQ(FaultOf(mesh), "The surface has 1 edge with more than two triangles.");
}

TEST(SurfaceTopology, FindsPinchedPoint)
{
  IndexedMesh mesh =
      test::Join(test::Tetrahedron({0, 0, 0}, 1.0), test::Tetrahedron({0, 0, 0}, -1.0));
  for (std::size_t t = 4; t < 8; ++t)
  {
    std::replace(mesh.Triangles[t].begin(), mesh.Triangles[t].end(), 4, 0);
    std::swap(mesh.Triangles[t][1], mesh.Triangles[t][2]);
  }
  const SurfaceTopology topology = DescribeTopology(mesh);
  EXPECT_EQ(topology.PinchedPoints, 1);
  EXPECT_EQ(topology.UnusedPoints, 1);
  EXPECT_EQ(topology.Parts, 2);
  EXPECT_EQ(topology.EulerCharacteristic, 4);
  EXPECT_EQ(FaultOf(mesh), "The surface has 1 pinched point, where it touches itself.");
}

TEST(SurfaceTopology, TellsOneSidedFromInconsistent)
{
  const SurfaceTopology strip = DescribeTopology(test::MoebiusStrip(9));
  EXPECT_FALSE(strip.IsOrientable);
  EXPECT_EQ(strip.Holes, 1);
  EXPECT_EQ(strip.EulerCharacteristic, 0);

  IndexedMesh sphere = test::Sphere(5);
  std::swap(sphere.Triangles[7][0], sphere.Triangles[7][1]);
  const SurfaceTopology turned = DescribeTopology(sphere);
  EXPECT_TRUE(turned.IsOrientable);
  EXPECT_EQ(turned.OrientationConflicts, 3);
  EXPECT_EQ(FaultOf(sphere), "The surface has 3 edges between triangles of opposite orientation.");
}

// The torus with one of its two seams joined the other way round.
TEST(SurfaceTopology, NamesKleinBottle)
{
  constexpr int Around = 8;
  constexpr int Across = 6;
  IndexedMesh mesh = test::Torus(Around, Across);
  for (std::size_t t = 2 * (Around - 1) * Across; t < mesh.Triangles.size(); ++t)
  {
    for (int& corner : mesh.Triangles[t])
    {
      corner = corner < Across ? (Across - corner) % Across : corner;
    }
  }
  const SurfaceTopology topology = DescribeTopology(mesh);
  EXPECT_EQ(topology.Holes, 0);
  EXPECT_EQ(topology.EulerCharacteristic, 0);
  EXPECT_EQ(FaultOf(mesh), "The surface is one-sided, like a Klein bottle.");
}

TEST(SurfaceTopology, NamesInsideOut)
{
  EXPECT_EQ(FaultOf(test::Reversed(test::Sphere(3))), "The surface is inside out.");
}

TEST(SurfaceTopology, CountsDuplicatesInAnyOrder)
{
  IndexedMesh mesh = test::Sphere(3);
  const auto [a, b, c] = mesh.Triangles[5];
  mesh.Triangles.push_back({c, b, a});
  mesh.Triangles.push_back({b, c, a});
  EXPECT_EQ(DescribeTopology(mesh).DuplicateTriangles, 2);
  EXPECT_EQ(FaultOf(mesh), "The surface has 2 duplicate triangles.");
  EXPECT_EQ(DescribeTopology({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}})
                .DuplicateTriangles,
            1);
}

TEST(SurfaceTopology, NamesFirstFaultOfBadInput)
{
  EXPECT_EQ(FaultOf({}), "The surface has no triangles.");
  IndexedMesh mesh = test::Sphere(2);
  mesh.Points.emplace_back(0, 0, 0);
  EXPECT_EQ(FaultOf(mesh), "The surface has 1 unused point.");
  mesh.Triangles.push_back({0, 0, 1});
  EXPECT_EQ(FaultOf(mesh), "The surface has 1 triangle with a repeated point.");
  mesh.Triangles.push_back({0, 1, static_cast<int>(mesh.Points.size())});
  mesh.Triangles.push_back({-1, 1, 2});
  EXPECT_EQ(FaultOf(mesh), "The surface has 2 triangles with invalid point indices.");
  mesh.Points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(FaultOf(mesh), "The surface has 1 non-finite point.");
  EXPECT_EQ(DescribeTopology(mesh).EulerCharacteristic, 2);
}

TEST(SurfaceTopology, CountsTrianglesWithoutArea)
{
  IndexedMesh mesh = test::Tetrahedron({0, 0, 0}, 1.0);
  mesh.Points[3] = {0.5, 0.0, 0.0};
  const SurfaceTopology topology = DescribeTopology(mesh);
  EXPECT_EQ(topology.FlatTriangles, 1);
  EXPECT_EQ(CheckClosedGenusZero(topology).Message(), "The surface encloses no volume.");
}

TEST(SurfaceTopology, PointsWithManyTrianglesAreNotSlow)
{
  EXPECT_EQ(FaultOf(test::DoubleCone(200'000)), ""); // minutes, were it quadratic
}
} // namespace
} // namespace palpate::surface_topology_test
