// Theorems about the harmonics as a whole, at degrees where a reference for each would be too slow.
#include "RadialModel.h"
#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"
#include "WorstCase.h"

#include <Eigen/Core>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::spherical_harmonic_properties_test
{
namespace
{
using test::Random;
using test::WorstCase;

Eigen::Map<const Eigen::VectorXd> AsVector(const std::vector<double>& values)
{
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

// The integral of Y (Y . c): c itself where the harmonics are orthonormal.
Eigen::VectorXd Project(int degree, const std::vector<double>& c)
{
  const SphericalHarmonicBasis basis(degree);
  const SphereQuadrature sphere(2 * degree);
  std::vector<double> values(basis.Size());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(basis.Size()));
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    basis.Evaluate(sphere.Directions[i], values.data());
    sum += sphere.Weights[i] * AsVector(values).dot(AsVector(c)) * AsVector(values);
  }
  return sum;
}

TEST(SphericalHarmonicProperties, ProjectionReturnsCoefficientsUpToDegree100)
{
  Random random(501);
  for (const int degree : {10, 33, 64, 100})
  {
    const std::vector<double> c = test::RandomCoefficients(random, degree);
    const Eigen::VectorXd difference = Project(degree, c) - AsVector(c);
    WorstCase worst;
    for (const double d : difference)
    {
      worst.Add(d);
    }
    // Each entry of the Gram matrix is accurate to some 1e-14, and (L+1)^2 of them contribute with
    // coefficients of random sign: L + 1 times that.
    EXPECT_LE(worst.Value(), 1e-14 * (degree + 1)) << degree;
  }
}

TEST(SphericalHarmonicProperties, ObeysParseval)
{
  Random random(502);
  for (const int degree : {16, 17, 64, 100})
  {
    const RadialModel model(degree, test::RandomCoefficients(random, degree, 1.0), Vector3::Zero());
    const SphereQuadrature sphere(2 * degree);
    double integral = 0.0;
    for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
    {
      integral += sphere.Weights[i] * std::pow(model.Radius(sphere.Directions[i]), 2);
    }
    // Parseval; tens of thousands of roundings of random sign.
    EXPECT_NEAR(integral / AsVector(model.Coefficients()).squaredNorm(), 1.0, 1e-13) << degree;
  }
}

TEST(SphericalHarmonicProperties, SquaresOfDegreeSumEvenlyUpToDegree300)
{
  Random random(503);
  constexpr int Degree = 300;
  const SphericalHarmonicBasis basis(Degree);
  std::vector<double> values(basis.Size());
  std::vector<Vector3> directions = test::RandomDirections(random, 20);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}});
  WorstCase worst;
  for (const Vector3& u : directions)
  {
    basis.Evaluate(u, values.data());
    for (int l = 0; l <= Degree; ++l)
    {
      double sum = 0.0;
      for (int m = -l; m <= l; ++m)
      {
        sum += std::pow(values[SphericalHarmonicBasis::Index(l, m)], 2);
      }
      worst.Add(sum * 4.0 * M_PI / (2 * l + 1) - 1.0);
    }
  }
  // Directions of one rounding's length error, raised to powers of up to 2 l.
  EXPECT_LE(worst.Value(), 1e-12);
}

TEST(SphericalHarmonicProperties, SquaredSlopesOfDegreeSumEvenly)
{
  // Sum over m of the products of gradients: l (l+1) (2l+1) / (8 pi) times the tangent projection.
  Random random(504);
  std::vector<Vector3> directions = test::RandomDirections(random, 10);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {1e-8, 0, 1}});
  for (const int degree : {1, 2, 7, 16, 17, 40})
  {
    std::vector<Eigen::Matrix3d> sums(directions.size(), Eigen::Matrix3d::Zero());
    for (int m = -degree; m <= degree; ++m)
    {
      std::vector<double> c(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
      c[SphericalHarmonicBasis::Index(degree, m)] = 1.0;
      const RadialModel model(degree, c, Vector3::Zero());
      for (std::size_t i = 0; i < directions.size(); ++i)
      {
        const Vector3 gradient = model.Evaluate(directions[i]).SurfaceGradient;
        sums[i] += gradient * gradient.transpose();
      }
    }
    const double share = degree * (degree + 1.0) * (2 * degree + 1) / (8 * M_PI);
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      const Vector3& u = directions[i];
      const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - u * u.transpose();
      // Values are good to 1e-14 at low degrees; slopes move by l roundings of the direction.
      EXPECT_LE((sums[i] / share - tangent).norm(), 1e-13) << degree;
    }
  }
}
} // namespace
} // namespace palpate::spherical_harmonic_properties_test
