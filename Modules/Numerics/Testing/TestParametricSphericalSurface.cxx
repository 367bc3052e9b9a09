#include "ParametricSphericalSurface.h"

#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicMeasures.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::Random;

// x(u) = axes * u.
ParametricSphericalSurface Ellipsoid(const Vector3& axes)
{
  const double scale = std::sqrt(4 * M_PI / 3);
  return {1,
          {std::vector<double>{0.0, 0.0, 0.0, scale * axes.x()},
           std::vector<double>{0.0, scale * axes.y(), 0.0, 0.0},
           std::vector<double>{0.0, 0.0, scale * axes.z(), 0.0}}};
}

TEST(ParametricSphericalSurface, HasPointsOfModel)
{
  Random random(401);
  for (const int degree : {0, 1, 5, 12, 20})
  {
    const SphericalHarmonicModel model = test::RandomOrgan(random, degree);
    const ParametricSphericalSurface surface = ParametricSphericalSurface::FromModel(model);
    EXPECT_EQ(surface.Degree(), degree + 1);
    for (const Vector3& u : test::RandomDirections(random, 50))
    {
      // Points lie up to 200 mm off the origin, where one rounding is 3e-14; hundreds of terms.
      EXPECT_LE((surface.Point(u) - model.PointWorld(u)).norm(), 1e-12) << degree;
    }
  }
}

TEST(ParametricSphericalSurface, HasNormalsOfModel)
{
  Random random(402);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 12);
  const ParametricSphericalSurface surface = ParametricSphericalSurface::FromModel(model);
  std::vector<Vector3> directions = test::RandomDirections(random, 50);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}});
  for (const Vector3& u : directions)
  {
    // Normals lose a factor of the degree (13) against points: 13 * 1e-13 / 20 mm.
    EXPECT_LE((surface.Normal(u) - model.Normal(u)).norm(), 1e-12);
  }
}

TEST(ParametricSphericalSurface, EllipsoidHasItsPointsAndNormals)
{
  Random random(403);
  const Vector3 axes(3.0, 5.0, 8.0);
  const ParametricSphericalSurface surface = Ellipsoid(axes);
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    EXPECT_LE((surface.Point(u) - axes.cwiseProduct(u)).norm(), 2e-14); // a few roundings of 8
    const Vector3 exact = u.cwiseQuotient(axes).normalized();
    EXPECT_LE((surface.Normal(u) - exact).norm(), 2e-14);
  }
}

TEST(ParametricSphericalSurface, MirroredSurfaceHasInwardNormals)
{
  const ParametricSphericalSurface surface = Ellipsoid({-2.0, 2.0, 2.0});
  const Vector3 u = Vector3(1.0, 2.0, 2.0) / 3.0;
  EXPECT_LT(surface.Normal(u).dot(surface.Point(u)), -1.9);
}

TEST(ParametricSphericalSurface, VolumeIsExactAndSigned)
{
  const double exact = 4.0 / 3.0 * M_PI * 3.0 * 5.0 * 8.0;
  EXPECT_NEAR(Ellipsoid({3.0, 5.0, 8.0}).Volume(), exact, 1e-12 * exact);
  EXPECT_NEAR(Ellipsoid({-3.0, 5.0, 8.0}).Volume(), -exact, 1e-12 * exact);
  Random random(404);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 8);
  EXPECT_NEAR(ParametricSphericalSurface::FromModel(model).Volume(), VolumeOf(model),
              1e-10 * VolumeOf(model)); // cancellation: the body lies away from the origin
}

TEST(ParametricSphericalSurface, AreaMatchesKnownBodies)
{
  EXPECT_NEAR(Ellipsoid({5.0, 5.0, 5.0}).Area(), 100.0 * M_PI, 1e-10);
  // Prolate spheroid, semi-axes a = 3, c = 5: 2 pi a^2 (1 + c / (a e) asin e), e^2 = 1 - a^2 / c^2.
  const double e = 0.8;
  const double exact = 2.0 * M_PI * 9.0 * (1.0 + 5.0 / (3.0 * e) * std::asin(e));
  EXPECT_NEAR(Ellipsoid({3.0, 3.0, 5.0}).Area(), exact, 1e-4 * exact);
}

TEST(ParametricSphericalSurface, NormalIsZeroWithoutTangentPlane)
{
  const ParametricSphericalSurface point(
      0, {std::vector<double>{1.0}, std::vector<double>{2.0}, std::vector<double>{3.0}});
  EXPECT_EQ(point.Normal({0.0, 0.0, 1.0}), Vector3(0.0, 0.0, 0.0));
  const ParametricSphericalSurface line = Ellipsoid({1.0, 0.0, 0.0});
  EXPECT_EQ(line.Normal({0.6, 0.0, 0.8}), Vector3(0.0, 0.0, 0.0));
}
} // namespace
} // namespace palpate
