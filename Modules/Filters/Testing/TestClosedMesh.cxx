#include "ClosedMesh.h"

#include "MeshShapes.h"
#include "MeshVoxels.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::closed_mesh_test
{
namespace
{
using namespace palpate::test;

void Append(const IndexedMesh& more, IndexedMesh& mesh)
{
  const int start = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), more.Points.begin(), more.Points.end());
  for (const std::array<int, 3>& t : more.Triangles)
  {
    mesh.Triangles.push_back({t[0] + start, t[1] + start, t[2] + start});
  }
}

IndexedMesh TwoSpheres(double distance)
{
  IndexedMesh mesh = Sphere(12, 10.0);
  Append(Sphere(12, 10.0, {distance, 0.0, 0.0}), mesh);
  return mesh;
}

// A sphere with a cap cut off that a hole of 4 mm needs.
IndexedMesh OpenSphere()
{
  IndexedMesh mesh = Sphere(16, 10.0);
  auto& triangles = mesh.Triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const std::array<int, 3>& t)
                                 { return mesh.Points[t[0]].z() > 9.6; }),
                  triangles.end());
  return mesh;
}

std::string FaultOf(const IndexedMesh& mesh)
{
  ClosedMesh made;
  return MakeClosedMesh(mesh, {}, {}, made).Message();
}

ClosedMesh Repaired(const IndexedMesh& mesh)
{
  ClosedMeshSettings settings;
  settings.Repairs = true;
  settings.RepairVoxels = 2.0e5;
  ClosedMesh made;
  const Status status = MakeClosedMesh(mesh, settings, {}, made);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_EQ(FaultOfGenusZero(DescribeTopology(made.Mesh)), "");
  return made;
}

double VolumeOf(const IndexedMesh& mesh)
{
  return DescribeTopology(mesh).Volume;
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(ClosedMesh, FineSphereStays)
{
  ClosedMesh made;
  ASSERT_TRUE(MakeClosedMesh(Sphere(16, 10.0), {}, {}, made).IsOk());
  EXPECT_EQ(made.Mesh.Triangles.size(), 20U * 16 * 16);
  EXPECT_EQ(made.Fault, "");
  EXPECT_NEAR(VolumeOf(made.Mesh), VolumeOf(Sphere(16, 10.0)), 1e-9);
}

TEST(ClosedMesh, DependsOnTrianglesNotOnNumbersOfPoints)
{
  const IndexedMesh sphere = Sphere(9, 10.0);
  IndexedMesh soup; // as STL: three points for each triangle
  for (const std::array<int, 3>& t : sphere.Triangles)
  {
    const int start = static_cast<int>(soup.Points.size());
    for (const int corner : t)
    {
      soup.Points.push_back(sphere.Points[corner]);
    }
    soup.Triangles.push_back({start, start + 1, start + 2});
  }
  ClosedMesh one;
  ClosedMesh other;
  ASSERT_TRUE(MakeClosedMesh(sphere, {}, {}, one).IsOk());
  ASSERT_TRUE(MakeClosedMesh(soup, {}, {}, other).IsOk());
  EXPECT_EQ(one.Mesh.Points, other.Mesh.Points);
  EXPECT_EQ(one.Mesh.Triangles, other.Mesh.Triangles);
}

TEST(ClosedMesh, MendsOrientation)
{
  IndexedMesh mesh = Sphere(16, 10.0);
  for (std::array<int, 3>& t : mesh.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  ClosedMesh made;
  ASSERT_TRUE(MakeClosedMesh(mesh, {}, {}, made).IsOk());
  EXPECT_GT(VolumeOf(made.Mesh), 0.0);
  EXPECT_EQ(made.Mends.ReversedTriangles, 20 * 16 * 16);
}

TEST(ClosedMesh, CoarseFacesAreSplitAndFineOnesMerged)
{
  ClosedMesh made;
  ASSERT_TRUE(MakeClosedMesh(Box({0, 0, 0}, {8, 8, 8}), {}, {}, made).IsOk());
  EXPECT_GT(made.Mesh.Triangles.size(), 2000U);
  EXPECT_NEAR(VolumeOf(made.Mesh), 512.0, 1e-9);
  ClosedMeshSettings settings;
  settings.MostTriangles = 2000;
  settings.FewestTriangles = 100;
  ASSERT_TRUE(MakeClosedMesh(Sphere(30, 10.0), settings, {}, made).IsOk());
  EXPECT_LE(made.Mesh.Triangles.size(), 2000U);
  EXPECT_EQ(made.GivenTriangles, 18000);
}

TEST(ClosedMesh, RejectsWhatIsNotOneClosedSurface)
{
  EXPECT_EQ(FaultOf(Torus(40, 20)), "has 1 handle");
  EXPECT_EQ(FaultOf(OpenSphere()), "has 1 hole");
  EXPECT_EQ(FaultOf(TwoSpheres(30.0)), "has 2 separate parts");
  IndexedMesh crossing = Sphere(16, 10.0);
  // The pole is pushed through the opposite side.
  crossing.Points[0] *= -1.5;
  EXPECT_TRUE(Contains(FaultOf(crossing), "has triangles that cross each other, such as at ("));
  IndexedMesh invalid = Sphere(2);
  invalid.Triangles[3][1] = 1'000'000;
  EXPECT_NE(FaultOf(invalid), "");
  invalid = Sphere(2);
  invalid.Points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(FaultOf(invalid), "");
  EXPECT_NE(FaultOf({}), "");
}

TEST(ClosedMesh, RepairCutsOrFillsHandle)
{
  const ClosedMesh made = Repaired(Torus(60, 30, 20.0, 6.0));
  EXPECT_EQ(made.Fault, "has 1 handle");
  EXPECT_EQ(made.Topology.CutHandles.Count + made.Topology.FilledHandles.Count, 1);
  EXPECT_GT(made.VoxelSize, 0.0);
}

TEST(ClosedMesh, RepairClosesHole)
{
  const ClosedMesh made = Repaired(OpenSphere());
  // The missing cap is 0.2 % of the volume.
  EXPECT_NEAR(VolumeOf(made.Mesh) / VolumeOf(Sphere(16, 10.0)), 1.0, 0.01);
}

TEST(ClosedMesh, RepairTellsHowMuchSurfaceItAdded)
{
  IndexedMesh half = Sphere(32, 10.0);
  auto& triangles = half.Triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const std::array<int, 3>& t)
                                 { return half.Points[t[0]].z() > 0.0; }),
                  triangles.end());
  const AddedSurface added = Repaired(half).Added;
  // The lid, less a rim of two voxels: pi (10 - rim)^2 of 3 pi 10^2. Its border is ragged.
  const double rim = 2.0 * Repaired(half).VoxelSize;
  EXPECT_NEAR(added.AreaPercent, 100.0 * (10.0 - rim) * (10.0 - rim) / 300.0, 3.0);
  EXPECT_NEAR(added.Distance, 10.0, 0.5);
  EXPECT_LT(added.Farthest.norm(), 1.0);
  EXPECT_EQ(Repaired(TwoSpheres(10.0)).Added.AreaPercent, 0.0);
}

TEST(ClosedMesh, RepairUnitesOverlappingPartsAndBridgesOthers)
{
  const ClosedMesh overlap = Repaired(TwoSpheres(10.0));
  // Two spheres less the lens between them: pi (4 r + d) (2 r - d)^2 / 12.
  const double sphere = VolumeOf(Sphere(12, 10.0));
  EXPECT_NEAR(VolumeOf(overlap.Mesh) / (2.0 * sphere - M_PI * 50.0 * 100.0 / 12.0), 1.0, 0.01);
  const ClosedMesh apart = Repaired(TwoSpheres(24.0));
  EXPECT_EQ(apart.Topology.Bridges.Count, 1);
}

TEST(ClosedMesh, RepairKeepsABodyThatIsInsideOut)
{
  IndexedMesh mesh = Sphere(12, 10.0);
  Append(Reversed(Sphere(12, 8.0, {22.0, 0.0, 0.0})), mesh);
  EXPECT_EQ(Repaired(mesh).Topology.Bridges.Count, 1);
}

// As masks: two bodies are not one, whatever a bridge between them looks like.
TEST(ClosedMesh, RepairJoinsNoBodiesThatAreFarApart)
{
  ClosedMesh made;
  ClosedMeshSettings settings;
  settings.Repairs = true;
  const Status status = MakeClosedMesh(TwoSpheres(28.0), settings, {}, made);
  EXPECT_NE(status.Message().find("mm apart, which a model would join"), std::string::npos)
      << status.Message();
}

TEST(ClosedMesh, PartIsKeptAloneByItsNumber)
{
  IndexedMesh mesh = Sphere(6, 1.0, {40.0, 0.0, 0.0});
  Append(Sphere(12, 10.0), mesh);
  for (const auto& [part, radius] : {std::pair(1, 10.0), std::pair(2, 1.0)})
  {
    ClosedMesh made;
    ClosedMeshSettings settings;
    settings.Part = part;
    ASSERT_TRUE(MakeClosedMesh(mesh, settings, {}, made).IsOk());
    EXPECT_EQ(made.Mends.DroppedParts, 1);
    EXPECT_NEAR(VolumeOf(made.Mesh) / VolumeOf(Sphere(part == 1 ? 12 : 6, radius)), 1.0, 1e-12);
  }
  ClosedMesh made;
  EXPECT_FALSE(MakeClosedMesh(mesh, {}, {}, made).IsOk());
}

// A ball wrung in the middle: one half of it is inside out.
TEST(ClosedMesh, RepairKeepsLobesThatACrossingTurnedInsideOut)
{
  IndexedMesh mesh = Sphere(24, 10.0);
  double volume = 0.0;
  const double inside = VolumeOf(mesh);
  for (Vector3& point : mesh.Points)
  {
    point.y() *= (point.x() - 1.0) / 10.0;
  }
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    // Of the pyramid over the triangle from the line where the lobes meet: of either sign.
    const Vector3 start(1.0, 0.0, 0.0);
    const Vector3 a = mesh.Points[t[0]] - start;
    volume += std::abs(a.dot((mesh.Points[t[1]] - start).cross(mesh.Points[t[2]] - start))) / 6.0;
  }
  EXPECT_LT(VolumeOf(mesh), 0.2 * inside);
  EXPECT_NEAR(VolumeOf(Repaired(mesh).Mesh), volume, 0.03 * volume);
  mesh.Triangles.pop_back(); // also with a hole
  EXPECT_NEAR(VolumeOf(Repaired(mesh).Mesh), volume, 0.03 * volume);
}

// Behind the wall, winding numbers depend on the direction in which they are counted.
TEST(ClosedMesh, RepairKeepsBothSidesOfAWallInside)
{
  IndexedMesh mesh;
  mesh.Points = {{10, 0, 0}, {-10, 0, 0}, {0, 10, 0}, {0, -10, 0}, {0, 0, 10}, {0, 0, -10}};
  mesh.Triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5},
                    {1, 2, 5}, {3, 1, 5}, {0, 3, 5}, {2, 3, 4}, {3, 2, 5}};
  const ClosedMesh made = Repaired(mesh);
  EXPECT_TRUE(Contains(made.Fault, "more than two triangles")) << made.Fault;
  constexpr double Octahedron = 4000.0 / 3.0;
  // Its edges get rounder; without a side it would be half.
  EXPECT_NEAR(VolumeOf(made.Mesh), Octahedron, 0.04 * Octahedron);
}

TEST(ClosedMesh, RepairRejectsWhatEnclosesNothing)
{
  IndexedMesh sheet;
  sheet.Points = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  sheet.Triangles = {{0, 1, 2}};
  ClosedMeshSettings settings;
  settings.Repairs = true;
  settings.RepairVoxels = 1.0e4;
  ClosedMesh made;
  EXPECT_TRUE(Contains(MakeClosedMesh(sheet, settings, {}, made).Message(), "encloses no volume"));
}

TEST(ClosedMesh, EveryStepCanBeCancelled)
{
  for (int calls = 0; calls < 4; ++calls)
  {
    int left = calls;
    ClosedMesh made;
    EXPECT_FALSE(MakeClosedMesh(
                     Sphere(16, 10.0), {}, [&left](double) { return left-- > 0; }, made)
                     .IsOk())
        << calls;
  }
}

TEST(MeshVoxels, CubesCoverMeshWithMargin)
{
  const IndexedMesh mesh = Box({-3, 5, 7}, {1, 6, 27});
  const VoxelCenters grid = CubesAround(mesh, 1000.0);
  const double side = grid.Axes(0, 0);
  EXPECT_NEAR(side, std::cbrt(4.0 * 1.0 * 20.0 / 1000.0), 1e-12);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = grid.Origin[axis];
    const double high = low + side * (grid.Size[static_cast<std::size_t>(axis)] - 1);
    EXPECT_LE(low + side, mesh.Points[0][axis]);
    EXPECT_GE(high - side, mesh.Points[7][axis]);
  }
}

TEST(MeshVoxels, DirectionsAgreeOnClosedMesh)
{
  const IndexedMesh mesh = Sphere(9, 10.0, {1.0, 2.0, 3.0});
  const VoxelCenters grid = CubesAround(mesh, 2.0e4);
  std::vector<std::uint8_t> one;
  std::vector<std::uint8_t> all;
  ASSERT_TRUE(FindInside(mesh, grid, true, one).IsOk());
  ASSERT_TRUE(FindInside(mesh, grid, false, all).IsOk());
  EXPECT_EQ(one, all);
  const auto inside = static_cast<double>(std::count(one.begin(), one.end(), 1));
  EXPECT_NEAR(inside * std::pow(grid.Axes(0, 0), 3) / VolumeOf(mesh), 1.0, 0.01);
}

TEST(MeshVoxels, IrregularShareIsWhatIsNotEnclosedJustOnce)
{
  EXPECT_EQ(IrregularShare(Sphere(12, 10.0)), 0.0);
  EXPECT_EQ(IrregularShare(Reversed(Sphere(12, 10.0))), 1.0);
  IndexedMesh nested = Sphere(12, 10.0);
  Append(Sphere(12, 5.0), nested);
  EXPECT_NEAR(IrregularShare(nested), 0.125, 0.002);
  IndexedMesh hollow = Sphere(12, 10.0);
  Append(Reversed(Sphere(12, 5.0)), hollow);
  EXPECT_EQ(IrregularShare(hollow), 0.0);
}
} // namespace
} // namespace palpate::closed_mesh_test
