#include "SurfacePaths.h"

#include "MeshShapes.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

namespace palpate::surface_paths_test
{
namespace
{
std::unique_ptr<const SurfacePaths> PathsOf(const IndexedMesh& mesh)
{
  std::unique_ptr<const SurfacePaths> paths;
  const Status status = SurfacePaths::Make(mesh, paths);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return paths;
}

SurfacePaths::Path PathOf(const SurfacePaths& paths, const Vector3& from, const Vector3& to)
{
  SurfacePaths::Path path;
  const Status status = paths.Find(from, to, path);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return path;
}

Vector3 RandomDirection(test::Random& random)
{
  std::normal_distribution<double> normal;
  return Vector3(normal(random), normal(random), normal(random)).normalized();
}

// Each part lies in a triangle, so its length is one along the surface.
void ExpectOnSurface(const SurfacePaths& paths, const SurfacePaths::Path& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.Points.size(); ++i)
  {
    const Vector3 middle = 0.5 * (path.Points[i] + path.Points[i - 1]);
    EXPECT_LT(paths.Nearest().Find(middle).Distance, 1e-9);
    length += (path.Points[i] - path.Points[i - 1]).norm();
  }
  EXPECT_NEAR(path.Length, length, 1e-12 * length);
}

// Shortest path along the edges from a point to all others.
std::vector<double> AlongEdges(const IndexedMesh& mesh, int from)
{
  std::vector<double> lengths(mesh.Points.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  std::vector<std::vector<int>> neighbours(mesh.Points.size());
  for (const auto& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      neighbours[t[k]].push_back(t[(k + 1) % 3]);
      neighbours[t[(k + 1) % 3]].push_back(t[k]);
    }
  }
  open.push({lengths[from] = 0.0, from});
  while (!open.empty())
  {
    const auto [length, at] = open.top();
    open.pop();
    for (const int next : neighbours[at])
    {
      const double through = length + (mesh.Points[next] - mesh.Points[at]).norm();
      if (through < lengths[next])
      {
        open.push({lengths[next] = through, next});
      }
    }
  }
  return lengths;
}

TEST(SurfacePaths, IsGreatCircleOfASphere)
{
  constexpr double Radius = 30.0;
  const auto paths = PathsOf(test::Sphere(20, Radius));
  test::Random random(5);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 from = RandomDirection(random);
    const Vector3 to = RandomDirection(random);
    const double angle = std::acos(std::clamp(from.dot(to), -1.0, 1.0));
    const SurfacePaths::Path path = PathOf(*paths, Radius * from, Radius * to);
    ExpectOnSurface(*paths, path);
    // The chord of an edge of 0.07 rad is shorter than its arc by 2e-4 of it, and passing a corner
    // on its other side may have been shorter by 5e-4.
    EXPECT_NEAR(path.Length, Radius * angle, 1e-3 * Radius * angle + 1e-9);
  }
}

// On two faces of a box, the unfolded faces are a plane.
TEST(SurfacePaths, EqualsUnfoldedFacesOfABox)
{
  const auto paths = PathsOf(test::Box(Vector3::Zero(), Vector3(10.0, 10.0, 10.0)));
  test::Random random(6);
  std::uniform_real_distribution<double> inner(3.0, 7.0);
  std::uniform_real_distribution<double> near(7.0, 10.0);
  for (int i = 0; i < 100; ++i)
  {
    const Vector3 top(near(random), inner(random), 10.0);
    const Vector3 side(10.0, inner(random), near(random));
    const double along = (10.0 - top.x()) + (10.0 - side.z());
    const double expected = std::hypot(along, top.y() - side.y());
    EXPECT_NEAR(PathOf(*paths, top, side).Length, expected, 1e-12);
  }
}

TEST(SurfacePaths, IsNoLongerThanAlongEdgesAndNoShorterThanTheChord)
{
  test::Random random(7);
  for (const IndexedMesh& mesh : {test::Lobed(12), test::Torus(40, 20)})
  {
    const auto paths = PathsOf(mesh);
    std::uniform_int_distribution<int> chosen(0, static_cast<int>(mesh.Points.size()) - 1);
    for (int i = 0; i < 20; ++i)
    {
      const int from = chosen(random);
      const std::vector<double> lengths = AlongEdges(mesh, from);
      for (int j = 0; j < 10; ++j)
      {
        const int to = chosen(random);
        const SurfacePaths::Path path = PathOf(*paths, mesh.Points[from], mesh.Points[to]);
        ExpectOnSurface(*paths, path);
        EXPECT_LE(path.Length, lengths[to] * (1.0 + 1e-9));
        EXPECT_GE(path.Length, (mesh.Points[from] - mesh.Points[to]).norm() - 1e-9);
      }
    }
  }
}

TEST(SurfacePaths, IsTheSameInBothDirections)
{
  const IndexedMesh mesh = test::Torus(40, 20);
  const auto paths = PathsOf(mesh);
  const SurfacePaths::Path there = PathOf(*paths, mesh.Points[3], mesh.Points[97]);
  const SurfacePaths::Path back = PathOf(*paths, mesh.Points[97], mesh.Points[3]);
  EXPECT_NEAR(there.Length, back.Length, 1e-9);
}

TEST(SurfacePaths, IsStraightWithinATriangle)
{
  const auto paths = PathsOf(test::Box(Vector3::Zero(), Vector3(10.0, 10.0, 10.0)));
  const SurfacePaths::Path path = PathOf(*paths, {1.0, 2.0, 10.0}, {1.5, 3.0, 10.0});
  EXPECT_EQ(path.Points.size(), 2U);
  EXPECT_NEAR(path.Length, std::hypot(0.5, 1.0), 1e-12);
}

// As in an STL file, where every triangle has points of its own.
TEST(SurfacePaths, JoinsPointsAtEqualPositions)
{
  const IndexedMesh whole = test::Sphere(6, 10.0);
  IndexedMesh loose;
  for (const auto& t : whole.Triangles)
  {
    const int first = static_cast<int>(loose.Points.size());
    for (const int point : t)
    {
      loose.Points.push_back(whole.Points[point]);
    }
    loose.Triangles.push_back({first, first + 1, first + 2});
  }
  const Vector3 from(10.0, 0.0, 0.0);
  const Vector3 to(0.0, 10.0, 0.0);
  EXPECT_NEAR(PathOf(*PathsOf(loose), from, to).Length, PathOf(*PathsOf(whole), from, to).Length,
              1e-9);
}

TEST(SurfacePaths, RefusesPointsOnSeparateParts)
{
  IndexedMesh mesh = test::Box(Vector3::Zero(), Vector3(1.0, 1.0, 1.0));
  const IndexedMesh other = test::Box(Vector3(5.0, 0.0, 0.0), Vector3(6.0, 1.0, 1.0));
  for (const auto& [a, b, c] : other.Triangles)
  {
    mesh.Triangles.push_back({a + 8, b + 8, c + 8});
  }
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  SurfacePaths::Path path;
  const Status status = PathsOf(mesh)->Find({0.0, 0.5, 0.5}, {6.0, 0.5, 0.5}, path);
  EXPECT_NE(status.Message().find("not connected"), std::string::npos);
}

TEST(SurfacePaths, RefusesMeshesThatAreNone)
{
  std::unique_ptr<const SurfacePaths> paths;
  EXPECT_FALSE(SurfacePaths::Make({}, paths).IsOk());
  EXPECT_FALSE(SurfacePaths::Make({{Vector3::Zero()}, {{0, 1, 2}}}, paths).IsOk());
  const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(
      SurfacePaths::Make({{Vector3::Zero(), Vector3::UnitX(), nowhere}, {{0, 1, 2}}}, paths)
          .IsOk());
}
} // namespace
} // namespace palpate::surface_paths_test
