#include "IcosahedronDirections.h"
#include "InputError.h"
#include "RandomModels.h"
#include "SpharmPdmCoefficients.h"
#include "TemporaryFolder.h"
#include "TestData.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace palpate::spharm_pdm_coefficients_test
{
namespace
{
using namespace palpate::test;

std::string RefusalOf(const std::string& text)
{
  try
  {
    SurfaceFromSpharmPdm(text, "folder/name.coef");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "accepted";
}

// Independent implementation of SPHARM-PDM's published basis: P_lm by the classical recurrence
// with the Condon-Shortley sign, rows l^2, l^2+2m-1 (cosine), l^2+2m (sine), no sqrt(2).
double LegendreWithPhase(int l, int m, double z)
{
  double start = 1.0;
  for (int k = 1; k <= m; ++k)
  {
    start *= -(2.0 * k - 1.0) * std::sqrt(1.0 - z * z);
  }
  double before = 0.0;
  double value = start;
  for (int k = m + 1; k <= l; ++k)
  {
    const double next = ((2.0 * k - 1.0) * z * value - (k + m - 1.0) * before) / (k - m);
    before = value;
    value = next;
  }
  return value;
}

double ValueByTheBook(const std::vector<double>& rows, int degree, const Vector3& u)
{
  const double phi = std::atan2(u.y(), u.x());
  double sum = 0.0;
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      const double scale = std::sqrt((2.0 * l + 1.0) / (4.0 * 3.14159265358979323846) *
                                     std::tgamma(l - m + 1.0) / std::tgamma(l + m + 1.0));
      const double p = scale * LegendreWithPhase(l, m, u.z());
      const auto row = static_cast<std::size_t>(l * l);
      sum += m == 0 ? p * rows[row]
                    : p * (rows[row + 2 * static_cast<std::size_t>(m) - 1] * std::cos(m * phi) +
                           rows[row + 2 * static_cast<std::size_t>(m)] * std::sin(m * phi));
    }
  }
  return sum;
}

std::array<std::vector<double>, 3> ScanRows(const std::string& text)
{
  std::array<std::vector<double>, 3> rows;
  std::size_t at = text.find('{', 1);
  for (; at != std::string::npos; at = text.find('{', at + 1))
  {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    EXPECT_EQ(std::sscanf(text.c_str() + at, "{%lf,%lf,%lf}", &x, &y, &z), 3);
    rows[0].push_back(x);
    rows[1].push_back(y);
    rows[2].push_back(z);
  }
  return rows;
}

TEST(SpharmPdmCoefficients, RealFilesMatchReferenceInLps)
{
  for (const char* name : {"spharm_coef/case0_hippoL.coef", "spharm_coef/andesred_07.coef"})
  {
    PALPATE_REQUIRE_FILE(DataPath(name));
    const std::string text = ReadAll(DataPath(name));
    const SurfaceModel surface = SurfaceFromSpharmPdm(text, name);
    const auto rows = ScanRows(text);
    const IcosahedronDirections sphere(3);
    for (const Vector3& u : sphere.Directions())
    {
      const Vector3 ras(ValueByTheBook(rows[0], surface.Degree(), u),
                        ValueByTheBook(rows[1], surface.Degree(), u),
                        ValueByTheBook(rows[2], surface.Degree(), u));
      // 26^2 terms of at most 100 mm, in two orders of summation.
      ASSERT_LT((surface.Point(u) - Vector3(-ras.x(), -ras.y(), ras.z())).norm(), 1e-9) << name;
    }
  }
}

TEST(SpharmPdmCoefficients, RealFilesRoundTripEveryDecimal)
{
  for (const char* name : {"spharm_coef/case0_hippoL.coef", "spharm_coef/andesred_07.coef"})
  {
    PALPATE_REQUIRE_FILE(DataPath(name));
    const std::string text = ReadAll(DataPath(name));
    const auto before = ScanRows(text);
    const auto after = ScanRows(SurfaceToSpharmPdm(SurfaceFromSpharmPdm(text, name), "copy.coef"));
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(after[k].size(), before[k].size());
      for (std::size_t i = 0; i < before[k].size(); ++i)
      {
        // One division and one multiplication by sqrt(2): two roundings.
        ASSERT_NEAR(after[k][i], before[k][i], 1e-15 * std::abs(before[k][i])) << name;
      }
    }
  }
}

TEST(SpharmPdmCoefficients, RadialModelGivesSameSurface)
{
  std::mt19937_64 random(7);
  for (const int degree : {0, 1, 4, 12})
  {
    const RadialModel model = RandomModel(random, degree);
    const SurfaceModel back = SurfaceFromSpharmPdm(SurfaceToSpharmPdm(model, "f"), "f");
    EXPECT_EQ(back.Degree(), degree + 1);
    const IcosahedronDirections sphere(4);
    for (const Vector3& u : sphere.Directions())
    {
      // Coordinates of about 100 mm, projected by a quadrature of some hundred terms.
      ASSERT_LT((back.Point(u) - model.PointWorld(u)).norm(), 1e-11) << "degree " << degree;
      // The model's normal is steep in u only where R is small; here R is near 20 mm.
      ASSERT_LT((back.Normal(u) - model.Normal(u)).norm(), 1e-10) << "degree " << degree;
    }
  }
}

TEST(SpharmPdmCoefficients, SphereInRasHasFlippedCenter)
{
  const double root = std::sqrt(4.0 * 3.14159265358979323846);
  const std::string text = SurfaceToSpharmPdm(RadialModel(0, {10.0 * root}, {1.0, 2.0, 3.0}), "f");
  const auto rows = ScanRows(text);
  // Row 0 is the mean point times sqrt(4 pi): RAS is (-1, -2, 3).
  EXPECT_NEAR(rows[0][0], -1.0 * root, 1e-13); // rounding of numbers near 10
  EXPECT_NEAR(rows[1][0], -2.0 * root, 1e-13);
  EXPECT_NEAR(rows[2][0], 3.0 * root, 1e-13);
}

TEST(SpharmPdmCoefficients, RoundTripsSurfaceModel)
{
  std::mt19937_64 random(8);
  const SurfaceModel surface = RandomSurfaceModel(random, 6);
  const SurfaceModel back = SurfaceFromSpharmPdm(SurfaceToSpharmPdm(surface, "f"), "f");
  for (int k = 0; k < 3; ++k)
  {
    for (std::size_t i = 0; i < surface.Coefficients(k).size(); ++i)
    {
      // Multiplied and divided by sqrt(2): two roundings.
      ASSERT_NEAR(back.Coefficients(k)[i], surface.Coefficients(k)[i],
                  1e-15 * std::abs(surface.Coefficients(k)[i]));
    }
  }
}

TEST(SpharmPdmCoefficients, IgnoresWhiteSpace)
{
  EXPECT_EQ(RefusalOf("{1,{1,2,3}}"), "accepted");
  EXPECT_EQ(RefusalOf(" { 1 ,\n{ 1.0 , -2e0 ,\t+3 } ,\n} \n"), "accepted");
}

TEST(SpharmPdmCoefficients, RejectsOtherText)
{
  for (const char* text :
       {"", "{", "{}", "{ 1,", "{ 1,{1,2,3}", "{ 2,{1,2,3},{1,2,3}}", "{ 0,}", "{ -1,{1,2,3}}",
        "{ 4,{1,2,3}}", "{ 1,{1,2}}", "{ 1,{1,2,3,4}}", "{ 1,{1,2,nan}}", "{ 1,{1,2,3}} more",
        "{ 1,{1,2,3},{1,2,3}}", "{ 2147483647,{1,2,3}}", "{ 99999999999,{1,2,3}}", "1,1,1"})
  {
    const std::string message = RefusalOf(text);
    EXPECT_NE(message.find("folder/name.coef"), std::string::npos) << text << ": " << message;
  }
}
} // namespace
} // namespace palpate::spharm_pdm_coefficients_test
