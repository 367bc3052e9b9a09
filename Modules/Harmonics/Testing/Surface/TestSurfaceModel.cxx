#include "SurfaceModel.h"

#include "ModelMeasures.h"
#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceCases.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace palpate::parametric_spherical_surface_test
{
namespace
{
using test::Random;
using test::SurfaceModelEllipsoid;

TEST(SurfaceModel, HasPointsOfModel)
{
  Random random(401);
  for (const int degree : {0, 1, 5, 12, 20})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    const SurfaceModel surface = SurfaceModel::FromModel(model);
    EXPECT_EQ(surface.Degree(), degree + 1);
    for (const Vector3& u : test::RandomDirections(random, 50))
    {
      // Points lie up to 200 mm off the origin, where one rounding is 3e-14; hundreds of terms.
      EXPECT_LE((surface.Point(u) - model.PointWorld(u)).norm(), 1e-12) << degree;
    }
  }
}

TEST(SurfaceModel, HasNormalsOfModel)
{
  Random random(402);
  const RadialModel model = test::RandomOrgan(random, 12);
  const SurfaceModel surface = SurfaceModel::FromModel(model);
  std::vector<Vector3> directions = test::RandomDirections(random, 50);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}});
  for (const Vector3& u : directions)
  {
    // Normals lose a factor of the degree (13) against points: 13 * 1e-13 / 20 mm.
    EXPECT_LE((surface.Normal(u) - model.Normal(u)).norm(), 1e-12);
  }
}

TEST(SurfaceModel, EllipsoidHasItsPointsAndNormals)
{
  Random random(403);
  const Vector3 axes(3.0, 5.0, 8.0);
  const SurfaceModel surface = SurfaceModelEllipsoid(axes);
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    EXPECT_LE((surface.Point(u) - axes.cwiseProduct(u)).norm(), 2e-14); // a few roundings of 8
    const Vector3 exact = u.cwiseQuotient(axes).normalized();
    EXPECT_LE((surface.Normal(u) - exact).norm(), 2e-14);
  }
}

TEST(SurfaceModel, MirroredSurfaceHasInwardNormals)
{
  const SurfaceModel surface = SurfaceModelEllipsoid({-2.0, 2.0, 2.0});
  const Vector3 u = Vector3(1.0, 2.0, 2.0) / 3.0;
  EXPECT_LT(surface.Normal(u).dot(surface.Point(u)), -1.9);
}

TEST(SurfaceModel, VolumeIsExactAndSigned)
{
  const double exact = 4.0 / 3.0 * M_PI * 3.0 * 5.0 * 8.0;
  EXPECT_NEAR(SurfaceModelEllipsoid({3.0, 5.0, 8.0}).Volume(), exact, 1e-12 * exact);
  EXPECT_NEAR(SurfaceModelEllipsoid({-3.0, 5.0, 8.0}).Volume(), -exact, 1e-12 * exact);
  Random random(404);
  const RadialModel model = test::RandomOrgan(random, 8);
  EXPECT_NEAR(SurfaceModel::FromModel(model).Volume(), VolumeOf(model), 1e-13 * VolumeOf(model));
}

TEST(SurfaceModel, AreaMatchesKnownBodies)
{
  EXPECT_NEAR(SurfaceModelEllipsoid({5.0, 5.0, 5.0}).Area(), 100.0 * M_PI, 1e-10);
  // Prolate spheroid, semi-axes a = 3, c = 5: 2 pi a^2 (1 + c / (a e) asin e), e^2 = 1 - a^2 / c^2.
  const double e = 0.8;
  const double exact = 2.0 * M_PI * 9.0 * (1.0 + 5.0 / (3.0 * e) * std::asin(e));
  EXPECT_NEAR(SurfaceModelEllipsoid({3.0, 3.0, 5.0}).Area(), exact, 1e-4 * exact);
}

TEST(SurfaceModel, NormalIsZeroWithoutTangentPlane)
{
  const SurfaceModel point(
      0, {std::vector<double>{1.0}, std::vector<double>{2.0}, std::vector<double>{3.0}});
  EXPECT_EQ(point.Normal({0.0, 0.0, 1.0}), Vector3(0.0, 0.0, 0.0));
  const SurfaceModel line = SurfaceModelEllipsoid({1.0, 0.0, 0.0});
  EXPECT_EQ(line.Normal({0.6, 0.0, 0.8}), Vector3(0.0, 0.0, 0.0));
}

TEST(SurfaceModel, TransformsItsPoints)
{
  Random random(405);
  const SurfaceModel surface = test::RandomSurface(random, 12);
  Matrix3 linear;
  linear << 1.0, 2.0, 3.0, -1.0, 0.5, 0.0, 2.0, 0.0, -1.0;
  const Vector3 offset(10.0, -20.0, 30.0);
  const SurfaceModel moved = surface.Transformed(linear, offset);
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    // Roundings of points some 1,000 mm off the origin.
    EXPECT_LE((moved.Point(u) - linear * surface.Point(u) - offset).norm(), 1e-11);
  }
}

TEST(SurfaceModel, ReparametrisesExactly)
{
  Random random(406);
  for (const int degree : {0, 1, 7, 20})
  {
    const SurfaceModel surface = test::RandomSurface(random, degree);
    Matrix3 turn = Eigen::AngleAxisd(2.0, test::RandomDirection(random)).toRotationMatrix();
    for (const double sign : {1.0, -1.0}) // a rotation, a reflection
    {
      turn *= sign;
      const SurfaceModel turned = surface.Reparametrized(turn);
      for (const Vector3& u : test::RandomDirections(random, 50))
      {
        // Some hundred roundings of 300 mm.
        EXPECT_LE((turned.Point(u) - surface.Point(turn * u)).norm(), 1e-11) << degree;
      }
    }
  }
}

TEST(SurfaceModel, PowerIsUnchangedByRotations)
{
  Random random(407);
  const SurfaceModel surface = test::RandomSurface(random, 9);
  const Matrix3 turn = Eigen::AngleAxisd(1.0, test::RandomDirection(random)).toRotationMatrix();
  const std::vector<double> power = surface.PowerSpectrum();
  const std::vector<double> rotated = surface.Transformed(turn, Vector3::Zero()).PowerSpectrum();
  const std::vector<double> turned = surface.Reparametrized(turn).PowerSpectrum();
  for (std::size_t l = 0; l < power.size(); ++l)
  {
    EXPECT_NEAR(rotated[l], power[l], 1e-12 * power[0]);
    EXPECT_NEAR(turned[l], power[l], 1e-12 * power[0]);
  }
}

TEST(SurfaceModel, ChangesDegree)
{
  Random random(408);
  const SurfaceModel surface = test::RandomSurface(random, 6);
  const SurfaceModel padded = surface.WithDegree(30);
  const SurfaceModel back = padded.WithDegree(6);
  EXPECT_EQ(padded.Degree(), 30);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(back.Coefficients(k), surface.Coefficients(k));
  }
  for (const Vector3& u : test::RandomDirections(random, 20))
  {
    EXPECT_LE((padded.Point(u) - surface.Point(u)).norm(), 1e-12); // roundings of 300 mm
  }
}

TEST(SurfaceModel, DerivativesAreThoseOfModel)
{
  Random random(409);
  const RadialModel model = test::RandomOrgan(random, 10);
  const SurfaceModel surface = SurfaceModel::FromModel(model);
  std::vector<Vector3> directions = test::RandomDirections(random, 50);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}});
  for (const Vector3& u : directions)
  {
    const auto exact = model.EvaluateSecondOrder(u);
    const auto found = surface.EvaluateSecondOrder(u);
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Vector3& t = found.Tangents[i];
      const double slope = exact.SurfaceGradient.dot(t);
      // x = R u along the great circle of t: x' = R' u + R t, x'' = (R'' - R) u + 2 R' t.
      const Vector3 first = slope * u + exact.Radius * t;
      const Vector3 second = (t.dot(exact.SurfaceHessian * t) - exact.Radius) * u + 2.0 * slope * t;
      EXPECT_LE((found.First[i] - first).norm(), 1e-11);
      EXPECT_LE((found.Second[2 * i] - second).norm(), 1e-10);
    }
  }
}
} // namespace
} // namespace palpate::parametric_spherical_surface_test
