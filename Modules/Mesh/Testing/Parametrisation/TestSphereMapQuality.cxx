#include "SphereMapQuality.h"

#include "ClosedMeshes.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::sphere_map_quality_test
{
namespace
{
using test::Random;

TEST(SphereMapQuality, RegularSolidsHaveNoDistortion)
{
  const IndexedMesh mesh = test::SphereMesh(1);
  const SphereMapQuality quality = MeasureSphereMap(mesh, mesh.Points);
  // Rounding of 20 equal solid angles.
  EXPECT_LE(quality.AreaDistortion, 1e-14);
  EXPECT_NEAR(quality.LeastRatio, 1.0, 1e-14);
  EXPECT_NEAR(quality.LargestRatio, 1.0, 1e-14);
}

// Tetrahedron with a right corner on the regular one: each face has a quarter of the sphere, but
// 1 : 1 : 1 : sqrt(3) of the surface.
TEST(SphereMapQuality, ComparesSharesOfArea)
{
  const IndexedMesh mesh = test::TetrahedronMesh();
  const double a = 1.0 / std::sqrt(3.0);
  const std::vector<Vector3> directions = {{-a, -a, -a}, {a, -a, a}, {-a, a, a}, {a, a, -a}};
  const std::vector<std::array<int, 3>> flipped = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const IndexedMesh oriented = {mesh.Points,
                                IsBijective(mesh.Triangles, directions) ? mesh.Triangles : flipped};
  ASSERT_TRUE(IsBijective(oriented.Triangles, directions));
  const double share = 1.0 / (3.0 + std::sqrt(3.0));
  const SphereMapQuality quality = MeasureSphereMap(oriented, directions);
  EXPECT_NEAR(quality.LargestRatio, 0.25 / share, 1e-13);
  EXPECT_NEAR(quality.LeastRatio, 0.25 / (std::sqrt(3.0) * share), 1e-13);
  EXPECT_NEAR(quality.AreaDistortion, 6.0 * (0.25 - share), 1e-13);
}

TEST(SphereMapQuality, MovedAndScaledSurfacesHaveTheSameQuality)
{
  Random random(1);
  const IndexedMesh mesh = test::RandomStarMesh(random, 4);
  const std::vector<Vector3> directions = test::SphereMesh(4).Points;
  const IndexedMesh copy = test::Moved(mesh, 7.0 * Matrix3::Identity(), {1.0, 2.0, 3.0});
  EXPECT_NEAR(MeasureSphereMap(mesh, directions).AreaDistortion,
              MeasureSphereMap(copy, directions).AreaDistortion, 1e-13); // rounding
}

TEST(SphereMapQuality, RefusesDistortedMaps)
{
  SphereMapQuality quality;
  quality.AreaDistortion = LargestAreaDistortion;
  EXPECT_TRUE(CheckSphereMap(quality).IsOk());
  quality.AreaDistortion = 0.47;
  EXPECT_NE(CheckSphereMap(quality).Message().find("too long and thin"), std::string::npos);
  quality.AreaDistortion = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CheckSphereMap(quality).IsOk());
}

TEST(SphereMapQuality, RejectsFoldedAndMirroredMaps)
{
  const IndexedMesh mesh = test::SphereMesh(3);
  EXPECT_TRUE(IsBijective(mesh.Triangles, mesh.Points));
  std::vector<Vector3> folded = mesh.Points;
  folded[40] = -folded[40];
  EXPECT_FALSE(IsBijective(mesh.Triangles, folded));
  std::vector<Vector3> mirrored = mesh.Points;
  for (Vector3& u : mirrored)
  {
    u.x() = -u.x();
  }
  EXPECT_FALSE(IsBijective(mesh.Triangles, mirrored));
  std::vector<Vector3> bad = mesh.Points;
  bad[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(IsBijective(mesh.Triangles, bad));
}

// A bipyramid wound twice around the axis: every triangle is positive, but the sphere is covered
// twice.
TEST(SphereMapQuality, RejectsMapsThatCoverTheSphereTwice)
{
  const IndexedMesh mesh = test::Bipyramid(10);
  EXPECT_TRUE(IsBijective(mesh.Triangles, mesh.Points));
  std::vector<Vector3> twice = mesh.Points;
  for (std::size_t i = 0; i < 10; ++i)
  {
    const double phi = 4.0 * M_PI * static_cast<double>(i) / 10.0;
    twice[2 + i] = {std::cos(phi), std::sin(phi), 0.0};
  }
  EXPECT_FALSE(IsBijective(mesh.Triangles, twice));
  // Each triangle alone is as it should be.
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    EXPECT_GT(SphericalDeterminant(twice[static_cast<std::size_t>(t[0])],
                                   twice[static_cast<std::size_t>(t[1])],
                                   twice[static_cast<std::size_t>(t[2])]),
              0.5);
  }
}
} // namespace
} // namespace palpate::sphere_map_quality_test
