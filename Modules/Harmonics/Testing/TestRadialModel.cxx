#include "RadialModel.h"

#include "IcosahedronDirections.h"
#include "ModelMeasures.h"
#include "ProjectedShapes.h"
#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <numeric>

namespace palpate::spherical_harmonic_model_test
{
namespace
{
using test::Random;

TEST(RadialModel, RadiusIsSumOverBasis)
{
  Random random(201);
  for (const int degree : {0, 1, 2, 3, 5, 12, 33, 64})
  {
    const SphericalHarmonicBasis basis(degree);
    const std::vector<double> c = test::RandomCoefficients(random, degree);
    const RadialModel model(degree, c, {1.0, 2.0, 3.0});
    std::vector<double> values(basis.Size());
    for (const Vector3& u : test::RandomDirections(random, 30))
    {
      basis.Evaluate(u, values.data());
      const double sum = std::inner_product(c.begin(), c.end(), values.begin(), 0.0);
      // (L+1)^2 terms of size about 1 summed in another order: 4225 * 3 * 1.1e-16 at worst.
      EXPECT_NEAR(model.Radius(u), sum, 1e-12) << degree;
      EXPECT_NEAR(model.Evaluate(u).Radius, sum, 1e-12) << degree;
    }
  }
}

TEST(RadialModel, MissingCoefficientsCountAsZero)
{
  const RadialModel model(2, {1.0, 2.0}, Vector3::Zero());
  const std::vector<double> expected{1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(model.Coefficients(), expected);
}

TEST(RadialModel, PointLiesAtRadiusFromCenter)
{
  Random random(202);
  const RadialModel model = test::RandomOrgan(random, 8);
  for (const Vector3& u : test::RandomDirections(random, 20))
  {
    const Vector3 expected = model.CenterWorld() + model.Radius(u) * u;
    EXPECT_EQ((model.PointWorld(u) - expected).norm(), 0.0);
  }
}

TEST(RadialModel, GradientOfLinearFunctionIsTangentPart)
{
  Random random(203);
  const Vector3 a(1.5, -2.0, 0.75);
  const double scale = std::sqrt(4 * M_PI / 3);
  const RadialModel model(1, {0.0, a.y() * scale, a.z() * scale, a.x() * scale}, Vector3::Zero());
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    const RadialModel::Sample sample = model.Evaluate(u);
    // A few roundings of numbers below 3.
    EXPECT_NEAR(sample.Radius, a.dot(u), 3e-15);
    EXPECT_LE((sample.SurfaceGradient - (a - a.dot(u) * u)).norm(), 6e-15);
  }
}

TEST(RadialModel, GradientMatchesFiniteDifference)
{
  Random random(204);
  for (const int degree : {1, 2, 4, 9, 16})
  {
    const RadialModel model(degree, test::RandomCoefficients(random, degree), Vector3::Zero());
    std::vector<Vector3> directions = test::RandomDirections(random, 40);
    directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}});
    for (const Vector3& u : directions)
    {
      const Vector3 gradient = model.Evaluate(u).SurfaceGradient;
      // Projection leaves the rounding of the full gradient, whose size is at most about 300.
      EXPECT_NEAR(gradient.dot(u), 0.0, 1e-12);
      const Vector3 tangent = u.unitOrthogonal();
      for (const Vector3& along : {tangent, Vector3(u.cross(tangent))})
      {
        const auto at = [&](double angle)
        { return model.Radius(std::cos(angle) * u + std::sin(angle) * along); };
        constexpr double H = 2e-4; // rad
        const double difference = (8 * (at(H) - at(-H)) - (at(2 * H) - at(-2 * H))) / (12 * H);
        // Rounding 30 * 2e-16 * degree / H = 5e-10; formula error H^4 / 30 times the fifth
        // derivative, 1.6e-15 * 16^5 * 30 / 30 = 2e-9.
        EXPECT_NEAR(gradient.dot(along), difference, 5e-9) << degree;
      }
    }
  }
}

TEST(RadialModel, TraceOfHessianIsEigenvalueOfDegree)
{
  Random random(207);
  for (const int degree : {0, 1, 2, 7, 12, 30})
  {
    std::vector<double> c(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
    const std::vector<double> all = test::RandomCoefficients(random, degree);
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(degree) * degree;
    std::copy(all.begin() + first, all.end(), c.begin() + first);
    const RadialModel model(degree, c, Vector3::Zero());
    std::vector<Vector3> directions = test::RandomDirections(random, 30);
    directions.emplace_back(0.0, 0.0, 1.0);
    directions.emplace_back(0.0, 0.0, -1.0);
    for (const Vector3& u : directions)
    {
      const auto sample = model.EvaluateSecondOrder(u);
      const double eigenvalue = degree * (degree + 1.0);
      // Roundings of second derivatives, which grow with the square of the degree.
      const double tolerance = 1e-13 * (1.0 + eigenvalue) * (degree + 1.0);
      EXPECT_NEAR(sample.SurfaceHessian.trace(), -eigenvalue * sample.Radius, tolerance);
      EXPECT_LE((sample.SurfaceHessian * u).norm(), tolerance);
      EXPECT_NEAR(sample.Radius, model.Radius(u), tolerance);
      EXPECT_LE((sample.SurfaceGradient - model.Evaluate(u).SurfaceGradient).norm(), tolerance);
    }
  }
}

TEST(RadialModel, HessianMatchesSecondDifference)
{
  Random random(208);
  const RadialModel model(12, test::RandomCoefficients(random, 12), Vector3::Zero());
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    const Vector3 tangent = u.unitOrthogonal();
    const auto along = [&](double angle)
    { return model.Radius(std::cos(angle) * u + std::sin(angle) * tangent); };
    // Error of the fourth derivative, about (12 h)^2 / 12 of values of size 12^2 * 13.
    constexpr double Step = 1e-4;
    const double difference = (along(Step) - 2.0 * along(0.0) + along(-Step)) / (Step * Step);
    const double exact = tangent.dot(model.EvaluateSecondOrder(u).SurfaceHessian * tangent);
    EXPECT_NEAR(exact, difference, 1e-3);
  }
}

TEST(RadialModel, NormalIsPerpendicularAndOutward)
{
  Random random(205);
  const RadialModel model = test::RandomOrgan(random, 10);
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    const Vector3 normal = model.Normal(u);
    EXPECT_NEAR(normal.norm(), 1.0, 4e-16); // rounding
    EXPECT_GT(normal.dot(u), 0.0);
    const Vector3 tangent = u.unitOrthogonal();
    for (const Vector3& along : {tangent, Vector3(u.cross(tangent))})
    {
      constexpr double H = 1e-5;
      const Vector3 step = model.PointWorld((u + H * along).normalized()) -
                           model.PointWorld((u - H * along).normalized());
      // Central difference: H^2 times third derivatives of a relief of a few mm at degree 10, and
      // the rounding of points 200 mm off the origin, 4e-14 / (2 H 20 mm).
      EXPECT_NEAR(normal.dot(step.normalized()), 0.0, 1e-8);
    }
  }
}

TEST(RadialModel, SphereMatchesClosedForms)
{
  const RadialModel sphere = test::Sphere(7.0);
  // Relative: some roundings.
  EXPECT_NEAR(VolumeOf(sphere) / (4.0 / 3.0 * M_PI * 343.0), 1.0, 1e-14);
  EXPECT_NEAR(AreaOf(sphere) / (4.0 * M_PI * 49.0), 1.0, 1e-14);
  const Vector3 u = Vector3(1.0, -2.0, 2.0) / 3.0;
  EXPECT_LE((sphere.Normal(u) - u).norm(), 1e-15);
}

TEST(RadialModel, EllipsoidMatchesClosedForms)
{
  const Vector3 axes(20.0, 24.0, 28.0);
  // Coefficients fall by about a factor of 4 every two degrees; at 48 the rest is below rounding
  // growth.
  EXPECT_NEAR(VolumeOf(test::Ellipsoid(axes, Matrix3::Identity(), 48)) /
                  (4.0 / 3.0 * M_PI * axes.prod()),
              1.0, 1e-12);
  const double a = 20.0;
  const double c = 26.0;
  const double e = std::sqrt(1.0 - a * a / (c * c));
  const double prolate = 2.0 * M_PI * a * a * (1.0 + c / (a * e) * std::asin(e));
  EXPECT_NEAR(AreaOf(test::Ellipsoid({a, a, c}, Matrix3::Identity(), 48)) / prolate, 1.0, 1e-12);
}

TEST(RadialModel, VolumeMatchesLimitOfMesh)
{
  Random random(206);
  const RadialModel model = test::RandomOrgan(random, 6);
  const auto meshVolume = [&model](int frequency)
  {
    const IcosahedronDirections directions(frequency);
    double volume = 0.0;
    for (const auto& face : directions.Triangles())
    {
      const auto at = [&](std::size_t corner)
      {
        const Vector3& u = directions.Directions()[static_cast<std::size_t>(face[corner])];
        return Vector3(model.Radius(u) * u);
      };
      volume += at(0).dot(at(1).cross(at(2))) / 6.0;
    }
    return volume;
  };
  // The error of inscribed facets is a series in f^-2: one extrapolation leaves f^-4.
  const double extrapolated = (4.0 * meshVolume(40) - meshVolume(20)) / 3.0;
  EXPECT_NEAR(VolumeOf(model) / extrapolated, 1.0, 1e-5);
}

TEST(RadialModel, VolumeAndAreaAreConverged)
{
  Random random(207);
  for (int sample = 0; sample < 5; ++sample)
  {
    const RadialModel model = test::RandomOrgan(random, 12);
    const SphereQuadrature fine(160);
    double volume = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < fine.Weights.size(); ++i)
    {
      const RadialModel::Sample s = model.Evaluate(fine.Directions[i]);
      volume += fine.Weights[i] * std::pow(s.Radius, 3) / 3.0;
      area += fine.Weights[i] * s.Radius * std::hypot(s.Radius, s.SurfaceGradient.norm());
    }
    EXPECT_NEAR(VolumeOf(model) / volume, 1.0, 1e-13); // exact: thousands of roundings
    // The area's integrand is not a polynomial; its quadrature converges geometrically.
    EXPECT_NEAR(AreaOf(model) / area, 1.0, 1e-8);
  }
}

TEST(RadialModel, PowerSpectrumSumsToSquaredRadius)
{
  Random random(208);
  const RadialModel model = test::RandomOrgan(random, 14);
  const std::vector<double> power = model.PowerSpectrum();
  ASSERT_EQ(power.size(), 15U);
  EXPECT_NEAR(power[0] / (400.0 * 4 * M_PI), 1.0, 1e-15); // (20 mm)^2 times 4 pi
  const SphereQuadrature sphere(28);
  double integral = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    integral += sphere.Weights[i] * std::pow(model.Radius(sphere.Directions[i]), 2);
  }
  // Parseval; hundreds of roundings.
  EXPECT_NEAR(std::accumulate(power.begin(), power.end(), 0.0) / integral, 1.0, 1e-13);
}

TEST(RadialModel, WithDegreeTruncatesOrPads)
{
  Random random(209);
  const RadialModel model = test::RandomOrgan(random, 6);
  const RadialModel higher = model.WithDegree(9);
  const RadialModel lower = model.WithDegree(3);
  EXPECT_EQ(higher.Degree(), 9);
  EXPECT_EQ(lower.Degree(), 3);
  EXPECT_EQ(lower.CenterWorld(), model.CenterWorld());
  const Vector3 u = test::RandomDirection(random);
  EXPECT_EQ(higher.Radius(u), model.Radius(u)); // adding zeros is exact
  const std::vector<double> expected(model.Coefficients().begin(),
                                     model.Coefficients().begin() + 16);
  EXPECT_EQ(lower.Coefficients(), expected);
  EXPECT_EQ(higher.WithDegree(6).Coefficients(), model.Coefficients());
}

TEST(RadialModel, DefaultIsPointAtOrigin)
{
  const RadialModel model;
  EXPECT_EQ(model.Degree(), 0);
  EXPECT_EQ(model.Radius({0, 0, 1}), 0.0);
  EXPECT_EQ(VolumeOf(model), 0.0);
}
} // namespace
} // namespace palpate::spherical_harmonic_model_test
