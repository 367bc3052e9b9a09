#include "MeshRays.h"

#include "IcosahedronDirections.h"
#include "MeshShapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::mesh_rays_test
{
namespace
{
MeshRays RaysOf(const IndexedMesh& mesh)
{
  MeshRays rays;
  EXPECT_TRUE(MeshRays::Make(mesh, rays).IsOk());
  return rays;
}

TEST(MeshRays, LeaveABoxThroughItsFaces)
{
  const IndexedMesh box = test::Box({-1.0, -2.0, -3.0}, {2.0, 4.0, 5.0});
  const MeshRays rays = RaysOf(box);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part(-0.9, 0.9);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 from(0.5 + 1.5 * part(random), 1.0 + 3.0 * part(random),
                       1.0 + 4.0 * part(random));
    const Vector3 direction = Vector3(part(random), part(random), part(random)).normalized();
    double exit = 1e30;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double to = direction[axis] > 0.0 ? box.Points.back()[axis] : box.Points.front()[axis];
      exit = std::min(exit, (to - from[axis]) / direction[axis]);
    }
    ASSERT_NEAR(rays.ExitFrom(from, direction), exit, 1e-12);
  }
}

TEST(MeshRays, DoNotSlipThroughEdgesAndCorners)
{
  const IndexedMesh sphere = test::Sphere(6, 5.0);
  const MeshRays rays = RaysOf(sphere);
  for (const auto& t : sphere.Triangles)
  {
    const Vector3& corner = sphere.Points[t[0]];
    const Vector3 middle = 0.5 * (corner + sphere.Points[t[1]]);
    EXPECT_NEAR(rays.ExitFrom(Vector3::Zero(), corner.normalized()), 5.0, 1e-9);
    EXPECT_NEAR(rays.ExitFrom(Vector3::Zero(), middle.normalized()), middle.norm(), 1e-9);
  }
  EXPECT_NEAR(rays.ExitFrom(Vector3::Zero(), Vector3::UnitX()), 5.0,
              0.1); // boxes are met in a face
}

TEST(MeshRays, FindNoExitFromOutside)
{
  const IndexedMesh box = test::Box(Vector3::Zero(), Vector3::Ones());
  const MeshRays rays = RaysOf(box);
  EXPECT_TRUE(std::isnan(rays.ExitFrom({-1.0, 0.4, 0.3}, Vector3::UnitX())));
  EXPECT_TRUE(std::isnan(rays.ExitFrom({-1.0, 0.4, 0.3}, -Vector3::UnitX())));
}

TEST(MeshRays, LeaveOutTheTrianglesOfTheirPoint)
{
  const IndexedMesh box = test::Box(Vector3::Zero(), Vector3::Ones());
  const Vector3 inward = Vector3(0.5, 0.6, 0.7).normalized();
  const MeshRays rays = RaysOf(box);
  EXPECT_TRUE(std::isnan(rays.ExitFrom(box.Points[0], inward))); // enters at once
  EXPECT_NEAR(rays.ExitFrom(box.Points[0], inward, 0), 1.0 / inward.z(), 1e-12);
}
} // namespace
} // namespace palpate::mesh_rays_test
