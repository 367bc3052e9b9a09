#include "SphericalHarmonicConventions.h"

#include "RandomShapes.h"
#include "SphericalHarmonicBasis.h"
#include "TextbookHarmonics.h"

#include <gtest/gtest.h>

namespace palpate::spherical_harmonic_conventions_test
{
namespace
{
using test::Random;
constexpr int Degree = 9;

// SPHARM-PDM's sum: associated Legendre functions with the phase, normalised, cosine and sine parts
// without the factor sqrt(2).
double SpharmPdmSum(const std::vector<double>& rows, const Vector3& u)
{
  long double sum = 0.0L;
  std::size_t next = 0;
  for (int l = 0; next < rows.size(); ++l)
  {
    sum += rows[next++] * test::TextbookComplex(l, 0, u).real();
    for (int m = 1; m <= l; ++m)
    {
      const std::complex<long double> y = test::TextbookComplex(l, m, u);
      sum += rows[next++] * y.real();
      sum += rows[next++] * y.imag();
    }
  }
  return static_cast<double>(sum);
}

TEST(SphericalHarmonicConventions, SpharmPdmRowsGiveSameFunction)
{
  Random random(303);
  const std::vector<double> rows = test::RandomCoefficients(random, Degree);
  const std::vector<double> c = FromSpharmPdm(rows);
  const SphericalHarmonicBasis basis(Degree);
  std::vector<double> values(basis.Size());
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    basis.Evaluate(u, values.data());
    double sum = 0.0;
    for (std::size_t k = 0; k < c.size(); ++k)
    {
      sum += c[k] * values[k];
    }
    EXPECT_NEAR(sum, SpharmPdmSum(rows, u), 2e-14); // a hundred terms of size 1
  }
}

TEST(SphericalHarmonicConventions, SpharmPdmRowsOfSphereAreKnown)
{
  // x = u: only first-order terms. Row 1 is z, row 2 the cosine part, row 3 the sine part.
  const double ours = std::sqrt(4 * M_PI / 3);
  const double theirs = std::sqrt(8 * M_PI / 3);
  const std::vector<double> ofX = ToSpharmPdm({0.0, 0.0, 0.0, ours});
  const std::vector<double> ofY = ToSpharmPdm({0.0, ours, 0.0, 0.0});
  const std::vector<double> ofZ = ToSpharmPdm({0.0, 0.0, ours, 0.0});
  const double tolerance = 1e-15; // two roundings
  for (std::size_t row = 0; row < 4; ++row)
  {
    EXPECT_NEAR(ofX[row], row == 2 ? -theirs : 0.0, tolerance);
    EXPECT_NEAR(ofY[row], row == 3 ? -theirs : 0.0, tolerance);
    EXPECT_NEAR(ofZ[row], row == 1 ? ours : 0.0, tolerance);
  }
}

TEST(SphericalHarmonicConventions, SpharmPdmRoundTripIsExactToRounding)
{
  Random random(304);
  const std::vector<double> c = test::RandomCoefficients(random, 20);
  const std::vector<double> back = FromSpharmPdm(ToSpharmPdm(c));
  ASSERT_EQ(back.size(), c.size());
  for (std::size_t k = 0; k < c.size(); ++k)
  {
    EXPECT_NEAR(back[k], c[k], 1e-15); // two roundings of numbers of size 1 to 4
  }
}

TEST(SphericalHarmonicConventions, FindsDegreeOfCount)
{
  for (int degree = 0; degree <= 100; ++degree)
  {
    const auto count = static_cast<std::size_t>((degree + 1) * (degree + 1));
    EXPECT_EQ(DegreeOfCount(count), degree);
    EXPECT_EQ(DegreeOfCount(count + 1), -1);
  }
  EXPECT_EQ(DegreeOfCount(0), -1);
  EXPECT_EQ(DegreeOfCount(168), -1);
}
} // namespace
} // namespace palpate::spherical_harmonic_conventions_test
