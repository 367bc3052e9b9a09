#include "GeodesicDistances.h"

#include "MeshShapes.h"
#include "RandomShapes.h"
#include "SurfacePaths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace palpate::geodesic_distances_test
{
namespace
{
using Condition = std::function<bool(double, double)>;

// A flat sheet of unit squares, each of two triangles, where their middle satisfies a condition.
IndexedMesh Sheet(int size, const Condition& isKept)
{
  IndexedMesh mesh;
  const int row = size + 1;
  for (int j = 0; j < row; ++j)
  {
    for (int i = 0; i < row; ++i)
    {
      mesh.Points.push_back(Vector3(i, j, 0.0));
    }
  }
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const int at = j * row + i;
      if (isKept(i + 0.5, j + 0.5))
      {
        mesh.Triangles.push_back({at, at + 1, at + row + 1});
        mesh.Triangles.push_back({at, at + row + 1, at + row});
      }
    }
  }
  return mesh;
}

std::vector<double> DistancesFrom(const IndexedMesh& mesh, const Vector3& from)
{
  NearestOnMesh nearest;
  EXPECT_TRUE(NearestOnMesh::Make(mesh, nearest).IsOk());
  std::vector<double> distances;
  EXPECT_TRUE(FindGeodesicDistances(mesh, nearest.Find(from), {}, distances).IsOk());
  return distances;
}

// Radii that go up and down by 20 %: shortest paths avoid the bumps.
IndexedMesh BumpySphere(int frequency)
{
  IndexedMesh mesh = test::Sphere(frequency, 20.0);
  for (Vector3& p : mesh.Points)
  {
    p *= 1.0 + 0.2 * std::sin(0.25 * p.x()) * std::sin(0.25 * p.y() + 1.0);
  }
  return mesh;
}

TEST(GeodesicDistances, IsStraightOnAFlatSheet)
{
  const IndexedMesh mesh = Sheet(12, [](double, double) { return true; });
  for (const Vector3& from : {Vector3(3.3, 4.1, 0.0), Vector3(5.0, 5.0, 0.0), Vector3(0, 0, 0)})
  {
    const std::vector<double> distances = DistancesFrom(mesh, from);
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      // A start within a triangle is moved off its edges by 1e-6 of a side.
      EXPECT_NEAR(distances[i], (mesh.Points[i] - from).norm(), 2e-6);
    }
  }
}

TEST(GeodesicDistances, BendsAroundCornersOfABoundary)
{
  // A wall from (0, 6) to (8, 7) that a path has to go around at its end.
  const IndexedMesh mesh =
      Sheet(12, [](double x, double y) { return !(x < 8.0 && y > 6.0 && y < 7.0); });
  const std::vector<double> distances = DistancesFrom(mesh, {1.0, 2.0, 0.0});
  const auto at = [&](int i, int j) { return distances[static_cast<std::size_t>(13 * j + i)]; };
  const double upToWall = std::hypot(7.0, 4.0);
  EXPECT_NEAR(at(8, 6), upToWall, 1e-9);
  EXPECT_NEAR(at(8, 7), upToWall + 1.0, 1e-9);
  EXPECT_NEAR(at(2, 10), upToWall + 1.0 + std::hypot(6.0, 3.0), 1e-9);
  EXPECT_NEAR(at(11, 3), std::hypot(10.0, 1.0), 1e-9);
}

TEST(GeodesicDistances, UnfoldsACube)
{
  IndexedMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.Points.push_back(Vector3(corner & 1, (corner >> 1) & 1, corner >> 2));
  }
  mesh.Triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const std::vector<double> fromCorner = DistancesFrom(mesh, {0.0, 0.0, 0.0});
  EXPECT_NEAR(fromCorner[7], std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(fromCorner[3], std::sqrt(2.0), 1e-12);
  const std::vector<double> fromSide = DistancesFrom(mesh, {0.5, 0.5, 0.0});
  for (int top = 4; top < 8; ++top)
  {
    EXPECT_NEAR(fromSide[top], std::hypot(1.5, 0.5), 2e-6);
  }
}

TEST(GeodesicDistances, AreThoseOfGreatCirclesButForTheTriangles)
{
  const IndexedMesh mesh = test::Sphere(16, 20.0);
  const std::vector<double> distances = DistancesFrom(mesh, mesh.Points[3]);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const double angle =
        std::atan2(mesh.Points[3].cross(mesh.Points[i]).norm(), mesh.Points[3].dot(mesh.Points[i]));
    EXPECT_NEAR(distances[i], 20.0 * angle, 1.5e-3 * 20.0 * angle); // edges h of 0.07 r: h^2 / 8
    EXPECT_LE(distances[i], 20.0 * angle + 1e-9);
  }
}

TEST(GeodesicDistances, AreTheSameBackwards)
{
  const IndexedMesh mesh = BumpySphere(8);
  test::Random random(7);
  std::uniform_int_distribution<std::size_t> pick(0, mesh.Points.size() - 1);
  const std::size_t one = pick(random);
  const std::vector<double> distances = DistancesFrom(mesh, mesh.Points[one]);
  for (int n = 0; n < 6; ++n)
  {
    const std::size_t other = pick(random);
    EXPECT_NEAR(DistancesFrom(mesh, mesh.Points[other])[one], distances[other],
                1e-9 * distances[other]);
  }
}

TEST(GeodesicDistances, AreNeverLongerThanAPath)
{
  std::unique_ptr<const SurfacePaths> paths;
  ASSERT_TRUE(SurfacePaths::Make(BumpySphere(10), paths).IsOk());
  const IndexedMesh& mesh = paths->Mesh();
  test::Random random(3);
  const NearestOnMesh::Result from = paths->Nearest().Find(20.0 * test::RandomDirection(random));
  std::vector<double> distances;
  ASSERT_TRUE(FindGeodesicDistances(mesh, from, {}, distances).IsOk());
  for (std::size_t i = 0; i < mesh.Points.size(); i += 41)
  {
    SurfacePaths::Path path;
    ASSERT_TRUE(paths->Find(from.Point, mesh.Points[i], path).IsOk());
    EXPECT_LE(distances[i], path.Length + 1e-5); // the start is moved off its edges
    ASSERT_TRUE(paths->FindShortest(from.Point, mesh.Points[i], {}, path).IsOk());
    EXPECT_LE(distances[i], path.Length + 1e-5);
  }
}

TEST(GeodesicDistances, LeadPathsAlongTheShortestRoute)
{
  std::unique_ptr<const SurfacePaths> paths;
  ASSERT_TRUE(SurfacePaths::Make(BumpySphere(10), paths).IsOk());
  const Vector3 from = paths->Nearest().Find({3.0, -17.0, 6.0}).Point;
  std::vector<double> distances;
  ASSERT_TRUE(
      FindGeodesicDistances(paths->Mesh(), paths->Nearest().Find(from), {}, distances).IsOk());
  double excess = 0.0;
  double excessOfFind = 0.0;
  for (std::size_t i = 0; i < distances.size(); i += 41)
  {
    SurfacePaths::Path path;
    ASSERT_TRUE(paths->Find(from, paths->Mesh().Points[i], path).IsOk());
    excessOfFind = std::max(excessOfFind, path.Length / distances[i] - 1.0);
    ASSERT_TRUE(paths->FindShortest(from, paths->Mesh().Points[i], {}, path).IsOk());
    excess = std::max(excess, path.Length / distances[i] - 1.0);
  }
  EXPECT_LT(excess, 1e-3); // some pass a corner on its other side
  EXPECT_GT(excessOfFind, 5e-3) << "another route is not tested";
}

TEST(GeodesicDistances, AreInfiniteOnOtherParts)
{
  IndexedMesh mesh = Sheet(4, [](double x, double) { return x < 1.0 || x > 3.0; });
  const std::vector<double> distances = DistancesFrom(mesh, {0.5, 2.2, 0.0});
  EXPECT_TRUE(std::isfinite(distances[1]));
  EXPECT_TRUE(std::isinf(distances[4]));
}

TEST(GeodesicDistances, Cancels)
{
  const IndexedMesh mesh = test::Sphere(8);
  std::vector<double> distances;
  EXPECT_FALSE(FindGeodesicDistances(
                   mesh, {mesh.Points[0], 0.0, 0}, [](double) { return false; }, distances)
                   .IsOk());
}
} // namespace
} // namespace palpate::geodesic_distances_test
