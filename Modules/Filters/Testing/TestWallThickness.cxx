#include "WallThickness.h"

#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace palpate::wall_thickness_test
{
namespace
{
Status Measure(const IndexedMesh& mesh, const Vector3& point, WallThickness& wall)
{
  NearestOnMesh nearest;
  EXPECT_TRUE(NearestOnMesh::Make(mesh, nearest).IsOk());
  return MeasureThickness(mesh, nearest, point, wall);
}

// The space between two spheres around the origin.
IndexedMesh Shell(double outer, double inner)
{
  IndexedMesh shell = test::Sphere(20, outer);
  const IndexedMesh cavity = test::Sphere(20, inner);
  const int first = static_cast<int>(shell.Points.size());
  shell.Points.insert(shell.Points.end(), cavity.Points.begin(), cavity.Points.end());
  for (const auto& [a, b, c] : cavity.Triangles)
  {
    shell.Triangles.push_back({a + first, c + first, b + first});
  }
  return shell;
}

TEST(WallThickness, IsThatOfAShellFromBothSides)
{
  const IndexedMesh shell = Shell(20.0, 15.0);
  WallThickness wall;
  for (const Vector3& direction :
       {Vector3(1.0, 0.0, 0.0), Vector3(0.3, -0.5, 0.8), Vector3(shell.Points[3] / 20.0)})
  {
    const Vector3 radial = direction.normalized();
    for (const double radius : {21.0, 14.5})
    {
      ASSERT_TRUE(Measure(shell, radius * radial, wall).IsOk());
      // Inscribed polyhedra of edges of 0.07 rad are up to 20 (1 - cos(0.04)) mm inside.
      EXPECT_NEAR(wall.Thickness, 5.0, 0.02);
      EXPECT_NEAR((wall.PointOnSurface - wall.OppositePoint).norm(), wall.Thickness, 1e-12);
    }
  }
}

// The ray from a corner of the mesh meets the opposite one.
TEST(WallThickness, IsTheDiameterOfASphereAlsoAtItsCorners)
{
  const IndexedMesh sphere = test::Sphere(10, 8.0);
  WallThickness wall;
  for (const Vector3& corner : sphere.Points)
  {
    ASSERT_TRUE(Measure(sphere, corner, wall).IsOk());
    EXPECT_NEAR(wall.Thickness, 16.0, 0.02);
  }
}

TEST(WallThickness, DoesNotDependOnOrientation)
{
  IndexedMesh box = test::Box(Vector3::Zero(), Vector3(4.0, 20.0, 30.0));
  const Vector3 above(5.0, 9.0, 11.0);
  WallThickness outwards;
  ASSERT_TRUE(Measure(box, above, outwards).IsOk());
  EXPECT_NEAR(outwards.Thickness, 4.0, 1e-9);
  for (auto& t : box.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  WallThickness inwards;
  ASSERT_TRUE(Measure(box, above, inwards).IsOk());
  EXPECT_NEAR((inwards.OppositePoint - outwards.OppositePoint).norm(), 0.0, 1e-9);
}

TEST(WallThickness, RefusesAnOpenSurface)
{
  IndexedMesh box = test::Box(Vector3::Zero(), Vector3(4.0, 20.0, 30.0));
  // Without the side at x = 0.
  const auto lies = [&](const std::array<int, 3>& t)
  {
    return std::all_of(t.begin(), t.end(), [&](int point) { return box.Points[point].x() == 0.0; });
  };
  box.Triangles.erase(std::remove_if(box.Triangles.begin(), box.Triangles.end(), lies),
                      box.Triangles.end());
  WallThickness wall;
  EXPECT_FALSE(Measure(box, {5.0, 9.0, 11.0}, wall).IsOk());
}
} // namespace
} // namespace palpate::wall_thickness_test
