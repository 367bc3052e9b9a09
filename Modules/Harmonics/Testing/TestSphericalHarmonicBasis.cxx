#include "SphericalHarmonicBasis.h"

#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "TextbookHarmonics.h"
#include "WorstCase.h"

#include <Eigen/Dense>
#include <array>
#include <gtest/gtest.h>

namespace palpate::spherical_harmonic_basis_test
{
namespace
{
using test::Random;
using test::WorstCase;

std::vector<double> Evaluate(const SphericalHarmonicBasis& basis, const Vector3& direction)
{
  std::vector<double> values(basis.Size(), std::nan(""));
  basis.Evaluate(direction, values.data());
  return values;
}

std::array<double, 16> ExplicitUpToDegree3(const Vector3& u)
{
  const double x = u.x();
  const double y = u.y();
  const double z = u.z();
  const double pi = M_PI;
  return {0.5 * std::sqrt(1 / pi),
          std::sqrt(3 / (4 * pi)) * y,
          std::sqrt(3 / (4 * pi)) * z,
          std::sqrt(3 / (4 * pi)) * x,
          0.5 * std::sqrt(15 / pi) * x * y,
          0.5 * std::sqrt(15 / pi) * y * z,
          0.25 * std::sqrt(5 / pi) * (3 * z * z - 1),
          0.5 * std::sqrt(15 / pi) * z * x,
          0.25 * std::sqrt(15 / pi) * (x * x - y * y),
          0.25 * std::sqrt(35 / (2 * pi)) * y * (3 * x * x - y * y),
          0.5 * std::sqrt(105 / pi) * x * y * z,
          0.25 * std::sqrt(21 / (2 * pi)) * y * (5 * z * z - 1),
          0.25 * std::sqrt(7 / pi) * z * (5 * z * z - 3),
          0.25 * std::sqrt(21 / (2 * pi)) * x * (5 * z * z - 1),
          0.25 * std::sqrt(105 / pi) * z * (x * x - y * y),
          0.25 * std::sqrt(35 / (2 * pi)) * x * (x * x - 3 * y * y)};
}

TEST(SphericalHarmonicBasis, HasOneEntryPerDegreeAndOrder)
{
  std::size_t next = 0;
  for (int l = 0; l <= 64; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      EXPECT_EQ(SphericalHarmonicBasis::Index(l, m), next++);
    }
    EXPECT_EQ(SphericalHarmonicBasis::CoefficientCount(l), next);
    EXPECT_EQ(SphericalHarmonicBasis(l).Size(), next);
  }
}

TEST(SphericalHarmonicBasis, EqualsExplicitFormulasUpToDegree3)
{
  Random random(101);
  const SphericalHarmonicBasis basis(3);
  WorstCase worst;
  for (const Vector3& u : test::RandomDirections(random, 200))
  {
    const std::vector<double> values = Evaluate(basis, u);
    const std::array<double, 16> exact = ExplicitUpToDegree3(u);
    for (std::size_t k = 0; k < exact.size(); ++k)
    {
      worst.Add(values[k] - exact[k]);
    }
  }
  // A dozen roundings of numbers below 2; 3 z^2 - 1 on both sides differs as |u| does from 1.
  EXPECT_LE(worst.Value(), 5e-15);
}

TEST(SphericalHarmonicBasis, EqualsTextbookSumUpToDegree64)
{
  Random random(102);
  const SphericalHarmonicBasis basis(64);
  WorstCase worst;
  std::vector<Vector3> directions = test::RandomDirections(random, 60);
  for (const double small : {1e-3, 1e-6, 1e-9, 1e-15})
  {
    directions.push_back(Vector3(small, 2 * small, 1.0).normalized());
    directions.push_back(Vector3(-small, small, -1.0).normalized());
    directions.push_back(Vector3(1.0, small, small).normalized());
  }
  for (const Vector3& u : directions)
  {
    const std::vector<double> values = Evaluate(basis, u);
    for (int l = 0; l <= 64; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        worst.Add(values[SphericalHarmonicBasis::Index(l, m)] -
                  static_cast<double>(test::TextbookReal(l, m, u)));
      }
    }
  }
  // The documented 1e-14 of the largest harmonic, sqrt((2l+1) / 4 pi) = 3.2.
  EXPECT_LE(worst.Value(), 3.2e-14);
}

TEST(SphericalHarmonicBasis, IsOrthonormal)
{
  constexpr int Degree = 24;
  const SphericalHarmonicBasis basis(Degree);
  const SphereQuadrature sphere(2 * Degree);
  const auto size = static_cast<Eigen::Index>(basis.Size());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const std::vector<double> values = Evaluate(basis, sphere.Directions[i]);
    const Eigen::Map<const Eigen::VectorXd> v(values.data(), size);
    gram += sphere.Weights[i] * v * v.transpose();
  }
  WorstCase worst;
  for (Eigen::Index i = 0; i < gram.size(); ++i)
  {
    worst.Add(gram.data()[i] - (i % (size + 1) == 0 ? 1.0 : 0.0));
  }
  // The quadrature is exact, so only roundings remain: about a thousand terms of total size 1,
  // each value itself good to 1e-14.
  EXPECT_LE(worst.Value(), 1e-13);
}

TEST(SphericalHarmonicBasis, ObeysAdditionTheorem)
{
  Random random(103);
  constexpr int Degree = 64;
  const SphericalHarmonicBasis basis(Degree);
  WorstCase worst;
  for (int sample = 0; sample < 50; ++sample)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 v = test::RandomDirection(random);
    const std::vector<double> atU = Evaluate(basis, u);
    const std::vector<double> atV = Evaluate(basis, v);
    for (int l = 0; l <= Degree; ++l)
    {
      double sum = 0.0;
      for (int m = -l; m <= l; ++m)
      {
        const std::size_t k = SphericalHarmonicBasis::Index(l, m);
        sum += atU[k] * atV[k];
      }
      const double exact =
          (2 * l + 1) / (4 * M_PI) * std::legendre(static_cast<unsigned>(l), u.dot(v));
      worst.Add(sum - exact);
    }
  }
  // Sums of size up to 10, P_l(u.v) moves by l^2 / 2 = 2000 roundings of u.v near u = v.
  EXPECT_LE(worst.Value(), 1e-12);
}

TEST(SphericalHarmonicBasis, IsAccurateAtPoles)
{
  const SphericalHarmonicBasis basis(64);
  for (const double pole : {1.0, -1.0})
  {
    const std::vector<double> values = Evaluate(basis, {0.0, 0.0, pole});
    for (int l = 0; l <= 64; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        const double exact = m == 0 ? std::pow(pole, l) * std::sqrt((2 * l + 1) / (4 * M_PI)) : 0.0;
        // One rounding error per step of the recurrence.
        EXPECT_NEAR(values[SphericalHarmonicBasis::Index(l, m)], exact, 64 * 3.2 * 2.3e-16);
      }
    }
  }
}

TEST(SphericalHarmonicBasis, IsContinuousTowardsPoles)
{
  const SphericalHarmonicBasis basis(64);
  const std::vector<double> pole = Evaluate(basis, {0.0, 0.0, 1.0});
  for (const double small : {1e-8, 1e-12, 1e-16, 1e-160, 1e-300, 5e-324})
  {
    const std::vector<double> values = Evaluate(basis, Vector3(small, -small, 1.0).normalized());
    WorstCase worst;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      worst.Add(values[k] - pole[k]);
    }
    // Slopes reach l (l+1) / 2 sqrt((2l+1) / 4 pi) < 1e4 within a distance of 1.5 small.
    EXPECT_LE(worst.Value(), 1.5e4 * small + 1e-13) << small;
  }
}

TEST(SphericalHarmonicBasis, NormalisesDirections)
{
  Random random(106);
  const SphericalHarmonicBasis basis(40);
  const Vector3 u = test::RandomDirection(random);
  const std::vector<double> unit = Evaluate(basis, u);
  const std::vector<double> longer = Evaluate(basis, 1024.0 * u);
  for (std::size_t k = 0; k < unit.size(); ++k)
  {
    EXPECT_EQ(unit[k], longer[k]); // scaling by a power of two is exact
  }
  for (const double value : Evaluate(basis, Vector3::Zero()))
  {
    EXPECT_TRUE(std::isnan(value));
  }
}

TEST(SphericalHarmonicBasis, HasParityOfDegree)
{
  Random random(104);
  const SphericalHarmonicBasis basis(32);
  const Vector3 u = test::RandomDirection(random);
  const std::vector<double> here = Evaluate(basis, u);
  const std::vector<double> there = Evaluate(basis, -u);
  for (int l = 0; l <= 32; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      const std::size_t k = SphericalHarmonicBasis::Index(l, m);
      EXPECT_EQ(there[k], l % 2 == 0 ? here[k] : -here[k]); // signs only: no rounding differs
    }
  }
}

TEST(SphericalHarmonicBasis, LowerDegreesAreIndependentOfHighest)
{
  Random random(105);
  const Vector3 u = test::RandomDirection(random);
  const std::vector<double> low = Evaluate(SphericalHarmonicBasis(9), u);
  const std::vector<double> high = Evaluate(SphericalHarmonicBasis(40), u);
  for (std::size_t k = 0; k < low.size(); ++k)
  {
    EXPECT_EQ(low[k], high[k]);
  }
}
} // namespace
} // namespace palpate::spherical_harmonic_basis_test
