#include "SurfaceCurvature.h"

#include "ProjectedShapes.h"
#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SurfaceCases.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

namespace palpate::surface_curvature_test
{
namespace
{
using test::Random;
using test::WorstCase;

SurfaceCurvature CurvatureOf(const RadialModel& model, const Vector3& u)
{
  return CurvatureAt(u, model.EvaluateSecondOrder(u));
}

std::vector<Vector3> DirectionsAndPoles(Random& random, int count)
{
  std::vector<Vector3> directions = test::RandomDirections(random, count);
  for (const double z : {1.0, -1.0})
  {
    directions.emplace_back(0.0, 0.0, z);
    directions.emplace_back(Vector3(1e-9, -1e-9, z).normalized());
  }
  return directions;
}

Matrix3 RandomRotation(Random& random)
{
  const Vector3 x = test::RandomDirection(random);
  const Vector3 y = x.cross(test::RandomDirection(random)).normalized();
  Matrix3 rotation;
  rotation << x, y, x.cross(y);
  return rotation;
}

void ExpectOrthonormalTangents(const RadialModel& model, const Vector3& u,
                               const SurfaceCurvature& curvature)
{
  const auto& [a, b] = curvature.Directions;
  // A few roundings of unit vectors.
  EXPECT_NEAR(a.norm(), 1.0, 1e-14);
  EXPECT_NEAR(b.norm(), 1.0, 1e-14);
  EXPECT_NEAR(a.dot(b), 0.0, 1e-14);
  EXPECT_NEAR(a.dot(model.Normal(u)), 0.0, 1e-14);
  EXPECT_NEAR(b.dot(model.Normal(u)), 0.0, 1e-14);
}

TEST(SurfaceCurvature, SphereHasCurvatureOfItsRadius)
{
  Random random(901);
  for (const double radius : {1e-3, 7.0, 1e4})
  {
    const RadialModel sphere = test::Sphere(radius);
    for (const Vector3& u : DirectionsAndPoles(random, 20))
    {
      const SurfaceCurvature found = CurvatureOf(sphere, u);
      // Relative: a few roundings.
      EXPECT_NEAR(found.Mean * radius, 1.0, 1e-14);
      EXPECT_NEAR(found.Gaussian * radius * radius, 1.0, 1e-14);
      EXPECT_NEAR(found.Principal[0] * radius, 1.0, 1e-14);
      EXPECT_NEAR(found.Principal[1] * radius, 1.0, 1e-14);
      ExpectOrthonormalTangents(sphere, u, found); // although every direction is principal
    }
  }
}

TEST(SurfaceCurvature, OffCentreSphereHasConstantCurvature)
{
  Random random(902);
  const RadialModel sphere = test::OffCenterSphere(10.0, {2.0, -1.0, 1.5}, 32);
  for (const Vector3& u : DirectionsAndPoles(random, 50))
  {
    const SurfaceCurvature found = CurvatureOf(sphere, u);
    // Harmonics fall by a factor of 7 per degree; the remainder is the rounding of second
    // derivatives, 32^2 times that of the radius.
    EXPECT_NEAR(found.Mean * 10.0, 1.0, 2e-11);
    EXPECT_NEAR(found.Gaussian * 100.0, 1.0, 4e-11);
    ExpectOrthonormalTangents(sphere, u, found);
  }
}

TEST(SurfaceCurvature, RotatedEllipsoidMatchesTextbook)
{
  Random random(903);
  const Vector3 axes(20.0, 24.0, 28.0);
  for (int turn = 0; turn < 3; ++turn)
  {
    const Matrix3 rotation = turn == 0 ? Matrix3(Matrix3::Identity()) : RandomRotation(random);
    const RadialModel ellipsoid = test::Ellipsoid(axes, rotation, 48);
    WorstCase mean;
    WorstCase gaussian;
    for (const Vector3& u : DirectionsAndPoles(random, 40))
    {
      const Vector3 x = rotation.transpose() * ellipsoid.PointWorld(u);
      const Vector3 squares = axes.cwiseProduct(axes);
      const double sum = x.cwiseQuotient(squares).squaredNorm();
      const double product = squares.prod();
      const double exactGaussian = 1.0 / (product * sum * sum);
      const double exactMean =
          (squares.sum() - x.squaredNorm()) / (2.0 * product * sum * std::sqrt(sum));
      const SurfaceCurvature found = CurvatureOf(ellipsoid, u);
      mean.Add(found.Mean / exactMean - 1.0);
      gaussian.Add(found.Gaussian / exactGaussian - 1.0);
      ExpectOrthonormalTangents(ellipsoid, u, found);
    }
    // The series is truncated where its terms are some 1e-13 of the radius, and second derivatives
    // are 48^2 times larger.
    EXPECT_LE(mean.Value(), 1e-9);
    EXPECT_LE(gaussian.Value(), 1e-9);
  }
}

TEST(SurfaceCurvature, ConvergesToEllipsoidWithDegree)
{
  Random random(904);
  const Vector3 axes(20.0, 24.0, 28.0);
  const std::vector<Vector3> directions = test::RandomDirections(random, 50);
  double last = 1.0;
  for (const int degree : {6, 12, 18, 24})
  {
    const RadialModel ellipsoid = test::Ellipsoid(axes, Matrix3::Identity(), degree);
    const RadialModel finer = test::Ellipsoid(axes, Matrix3::Identity(), 48);
    WorstCase error;
    for (const Vector3& u : directions)
    {
      error.Add(CurvatureOf(ellipsoid, u).Mean / CurvatureOf(finer, u).Mean - 1.0);
    }
    // Coefficients fall by about 4 every two degrees, second derivatives grow: a factor of ten
    // every six degrees at least.
    EXPECT_LE(error.Value(), 0.1 * last) << degree;
    last = error.Value();
  }
}

TEST(SurfaceCurvature, NormalRotatesByPrincipalCurvature)
{
  Random random(905);
  const RadialModel organ = test::RandomOrgan(random, 12);
  for (const Vector3& u : DirectionsAndPoles(random, 40))
  {
    const SurfaceCurvature found = CurvatureOf(organ, u);
    EXPECT_GE(found.Principal[0], found.Principal[1]);
    EXPECT_NEAR(found.Mean, 0.5 * (found.Principal[0] + found.Principal[1]), 1e-14);
    EXPECT_NEAR(found.Gaussian, found.Principal[0] * found.Principal[1], 1e-13);
    for (std::size_t k = 0; k < 2; ++k)
    {
      constexpr double H = 1e-4; // rad
      const Vector3& along = found.Directions[k];
      const Vector3 tangent = (along - along.dot(u) * u).normalized();
      const auto at = [&](double angle)
      { return Vector3(std::cos(angle) * u + std::sin(angle) * tangent); };
      const Vector3 turn = organ.Normal(at(H)) - organ.Normal(at(-H));
      const Vector3 step = organ.PointWorld(at(H)) - organ.PointWorld(at(-H));
      // Olinde Rodrigues: dn = k dx. The difference has an error of H^2 / 6 times third
      // derivatives, 12^3 times curvatures of about 0.1, and rounding 1e-13 / H.
      EXPECT_LE((turn / step.norm() - found.Principal[k] * step.normalized()).norm(), 1e-6);
      EXPECT_GT(std::abs(step.normalized().dot(along)), 1.0 - 1e-6);
    }
  }
}

TEST(SurfaceCurvature, GaussianCurvatureIntegratesToFourPi)
{
  Random random(906);
  const SphereQuadrature sphere(120);
  for (int sample = 0; sample < 3; ++sample)
  {
    const RadialModel organ = test::RandomOrgan(random, 7);
    double integral = 0.0;
    for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
    {
      const Vector3& u = sphere.Directions[i];
      const auto s = organ.EvaluateSecondOrder(u);
      const double area = s.Radius * std::hypot(s.Radius, s.SurfaceGradient.norm());
      integral += sphere.Weights[i] * area * CurvatureAt(u, s).Gaussian;
    }
    // Gauss and Bonnet. The integrand is not a polynomial; its quadrature converges geometrically.
    EXPECT_NEAR(integral / (4.0 * M_PI), 1.0, 1e-10);
  }
}

TEST(SurfaceCurvature, OffsetAreaGrowsByMeanCurvature)
{
  Random random(907);
  const RadialModel organ = test::RandomOrgan(random, 5);
  const SphereQuadrature sphere(40);
  constexpr double Step = 1e-4;   // rad
  constexpr double Offset = 0.01; // mm
  double growth = 0.0;
  double integral = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const Vector3& u = sphere.Directions[i];
    const Vector3 first = u.unitOrthogonal();
    const Vector3 second = u.cross(first);
    const auto areaAt = [&](double offset)
    {
      const auto slope = [&](const Vector3& t) -> Vector3
      {
        const auto at = [&](double angle) -> Vector3
        {
          const Vector3 v = std::cos(angle) * u + std::sin(angle) * t;
          return organ.Radius(v) * v + offset * organ.Normal(v);
        };
        return (at(Step) - at(-Step)) / (2.0 * Step);
      };
      return slope(first).cross(slope(second)).norm();
    };
    growth += sphere.Weights[i] * (areaAt(Offset) - areaAt(-Offset)) / (2.0 * Offset);
    const auto s = organ.EvaluateSecondOrder(u);
    const double area = s.Radius * std::hypot(s.Radius, s.SurfaceGradient.norm());
    integral += sphere.Weights[i] * area * 2.0 * CurvatureAt(u, s).Mean;
  }
  // Both sums have the same quadrature; the differences have an error of Step^2 and, as the area is
  // quadratic in the offset, rounding of 1e-11 / Offset of 500.
  EXPECT_NEAR(growth / integral, 1.0, 1e-6);
}

TEST(SurfaceCurvature, MirroredRadiusHasSameCurvature)
{
  Random random(908);
  const RadialModel organ = test::RandomOrgan(random, 8);
  std::vector<double> mirrored = organ.Coefficients();
  for (int l = 0; l <= 8; ++l) // -R(-u): a change of sign for even degrees
  {
    for (int m = -l; m <= l; ++m)
    {
      mirrored[SphericalHarmonicBasis::Index(l, m)] *= l % 2 == 0 ? -1.0 : 1.0;
    }
  }
  const RadialModel negative(8, mirrored, organ.CenterWorld());
  for (const Vector3& u : test::RandomDirections(random, 20))
  {
    const SurfaceCurvature expected = CurvatureOf(organ, -u);
    const SurfaceCurvature found = CurvatureOf(negative, u);
    ASSERT_LT(negative.Radius(u), 0.0);
    EXPECT_NEAR(found.Mean, expected.Mean, 1e-13); // roundings of second derivatives / 20 mm
    EXPECT_NEAR(found.Gaussian, expected.Gaussian, 1e-13);
    EXPECT_NEAR(std::abs(found.Directions[0].dot(expected.Directions[0])), 1.0, 1e-9);
  }
}

TEST(SurfaceCurvature, IsNanWhereSurfaceMeetsCentre)
{
  const SurfaceCurvature point = CurvatureOf(RadialModel(), Vector3::UnitX());
  EXPECT_TRUE(std::isnan(point.Mean));
  EXPECT_TRUE(std::isnan(point.Gaussian));
  EXPECT_TRUE(std::isnan(point.Principal[0]));
  EXPECT_TRUE(point.Directions[0].array().isNaN().all());
  // R = x on the sphere: zero with a slope.
  const RadialModel touching(1, {0.0, 0.0, 0.0, 1.0}, Vector3::Zero());
  EXPECT_TRUE(std::isnan(CurvatureOf(touching, Vector3::UnitZ()).Mean));
}

TEST(SurfaceCurvature, SurfaceModelHasThatOfItsModel)
{
  Random random(931);
  const RadialModel model = test::RandomOrgan(random, 8);
  const SurfaceModel surface = SurfaceModel::FromModel(model);
  for (const Vector3& u : DirectionsAndPoles(random, 50))
  {
    const SurfaceCurvature exact = CurvatureOf(model, u);
    const SurfaceCurvature found = CurvatureAt(surface.EvaluateSecondOrder(u));
    // Second derivatives err by 1e-12 mm of some 20.
    EXPECT_NEAR(found.Mean, exact.Mean, 1e-11);
    EXPECT_NEAR(found.Gaussian, exact.Gaussian, 1e-12);
    EXPECT_NEAR(found.Principal[0], exact.Principal[0], 1e-9); // roots near umbilic points
    EXPECT_NEAR(found.Principal[1], exact.Principal[1], 1e-9);
    const auto& [a, b] = found.Directions;
    EXPECT_NEAR(a.norm(), 1.0, 1e-14);
    EXPECT_NEAR(b.norm(), 1.0, 1e-14);
    EXPECT_NEAR(a.dot(b), 0.0, 1e-14);
    EXPECT_LE((a.cross(b) - model.Normal(u)).norm(), 1e-12); // as the normals of both
  }
}

TEST(SurfaceCurvature, SurfaceModelEllipsoidHasKnownCurvature)
{
  Random random(932);
  const Vector3 axes(3.0, 5.0, 8.0);
  const SurfaceModel surface = test::SurfaceModelEllipsoid(axes);
  for (const Vector3& u : DirectionsAndPoles(random, 50))
  {
    const SurfaceCurvature found = CurvatureAt(surface.EvaluateSecondOrder(u));
    // With h = |u / axes|^-1: K = h^4 / (abc)^2, 2 H = (sum of axes^2 - |x|^2) h^3 / (abc)^2.
    const double h = 1.0 / u.cwiseQuotient(axes).norm();
    const double product = axes.prod();
    const double square = axes.cwiseProduct(u).squaredNorm();
    EXPECT_NEAR(found.Gaussian, std::pow(h, 4) / (product * product), 1e-13);
    EXPECT_NEAR(found.Mean,
                0.5 * (axes.squaredNorm() - square) * std::pow(h, 3) / (product * product), 1e-13);
  }
}

TEST(SurfaceCurvature, ParametricCurvatureDoesNotDependOnParameters)
{
  Random random(933);
  const SurfaceModel surface = test::RandomSurface(random, 8);
  const Matrix3 turn = RandomRotation(random);
  const SurfaceModel turned = surface.Reparametrized(turn);
  for (const Vector3& u : DirectionsAndPoles(random, 30))
  {
    const SurfaceCurvature a = CurvatureAt(turned.EvaluateSecondOrder(u));
    const SurfaceCurvature b = CurvatureAt(surface.EvaluateSecondOrder(turn * u));
    // Rough bodies have places of small tangents, where curvatures are large.
    EXPECT_NEAR(a.Mean, b.Mean, 1e-9 * (1.0 + std::abs(b.Principal[0] - b.Principal[1])));
  }
}

TEST(SurfaceCurvature, ParametricPointHasNone)
{
  const SurfaceModel point(0, {std::vector<double>{1.0}, {2.0}, {3.0}});
  EXPECT_TRUE(std::isnan(CurvatureAt(point.EvaluateSecondOrder(Vector3::UnitZ())).Mean));
}
} // namespace
} // namespace palpate::surface_curvature_test
