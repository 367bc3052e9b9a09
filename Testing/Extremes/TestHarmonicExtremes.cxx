// Spherical harmonics at degrees, places and sizes beyond those of any organ.
#include "IcosahedronDirections.h"
#include "LegendreSums.h"
#include "ModelMeasures.h"
#include "RandomShapes.h"
#include "SphericalHarmonicReferences.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace palpate::harmonic_extremes_test
{
namespace
{
using test::LegendreSum;
using test::Random;
using test::WorstCase;

constexpr int HighestDegree = 2000;

// The poles, their neighbourhood down to where squares underflow, the equator, and random places.
std::vector<Vector3> ExtremeDirections(const Vector3& anywhere)
{
  std::vector<Vector3> directions{anywhere, -anywhere, {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}};
  for (const double z : {1.0, -1.0})
  {
    directions.emplace_back(0.0, 0.0, z);
    for (const double off : {1e-3, 1e-8, 1e-15, 1e-160, 1e-300})
    {
      directions.push_back(Vector3(0.8 * off, -0.6 * off, z).normalized());
    }
  }
  return directions;
}

TEST(HarmonicExtremes, SquaresOfEveryDegreeUpTo2000SumToTheAdditionTheorem)
{
  Random random(8800);
  const SphericalHarmonicBasis basis(HighestDegree);
  std::vector<double> values(basis.Size());
  for (const Vector3& u : ExtremeDirections(test::RandomDirection(random)))
  {
    basis.Evaluate(u, values.data());
    WorstCase off;
    for (int l = 0; l <= HighestDegree; ++l)
    {
      long double squares = 0.0L;
      for (int m = -l; m <= l; ++m)
      {
        const double value = values[SphericalHarmonicBasis::Index(l, m)];
        squares += static_cast<long double>(value) * value;
      }
      off.Add(static_cast<double>(squares * 4.0L * M_PIl / (2 * l + 1) - 1.0L));
    }
    // Twice the documented 1e-12 of the largest harmonic up to degree 1000, for twice the degree:
    // roundings of a recurrence add up.
    EXPECT_LE(off.Value(), 4e-12) << u.transpose();
  }
}

// Coefficients Y_lm(v) make all degrees add up at v, to the largest possible value.
struct PeakedModel
{
  PeakedModel(int degree, const Vector3& peak) : Peak(peak), Coefficients(Values(degree, peak)) {}

  static std::vector<double> Values(int degree, const Vector3& peak)
  {
    const SphericalHarmonicBasis basis(degree);
    std::vector<double> values(basis.Size());
    basis.Evaluate(peak, values.data());
    return values;
  }

  Vector3 Peak;
  std::vector<double> Coefficients;
};

struct Errors
{
  WorstCase Radius;
  WorstCase Gradient;
  bool IsFinite = true;
};

// Relative to the largest value that coefficients of this length can reach.
Errors ErrorsOf(int degree, const PeakedModel& peaked, const std::vector<Vector3>& directions)
{
  const RadialEvaluator evaluator(degree, peaked.Coefficients);
  const test::ReferenceScale scale(degree, peaked.Coefficients);
  Errors errors;
  for (const Vector3& u : directions)
  {
    const LegendreSum exact(degree, peaked.Peak, u);
    const auto sample = evaluator.Evaluate(u);
    errors.Radius.Add((sample.Radius - exact.Value) / scale.Radius);
    errors.Radius.Add((evaluator.Radius(u) - exact.Value) / scale.Radius);
    errors.Gradient.Add((sample.SurfaceGradient - exact.Gradient).norm() / scale.Gradient);
    errors.IsFinite =
        errors.IsFinite && evaluator.EvaluateSecondOrder(u).SurfaceHessian.allFinite();
  }
  return errors;
}

void ExpectTrueToTheDegree(int degree, double bound)
{
  Random random(8801);
  const std::vector<Vector3> directions = ExtremeDirections(test::RandomDirection(random));
  for (const std::size_t peak : {0, 2, 4, 7, 9}) // random, equator, pole, 1e-15 from it, 1e-300
  {
    const Errors errors = ErrorsOf(degree, PeakedModel(degree, directions[peak]), directions);
    EXPECT_LE(errors.Radius.Value(), bound) << degree << ' ' << directions[peak].transpose();
    EXPECT_LE(errors.Gradient.Value(), bound) << degree << ' ' << directions[peak].transpose();
    EXPECT_TRUE(errors.IsFinite) << degree << ' ' << directions[peak].transpose();
  }
}

TEST(HarmonicExtremes, RadiusAndGradientOfDegree2000AreAccurateEverywhere)
{
  // The documented 1e-12 up to degree 1000, for twice the degree.
  ExpectTrueToTheDegree(HighestDegree, 2e-12);
}

// Every number is multiplied by the same power of two, which causes no rounding.
TEST(HarmonicExtremes, RadiiFromANanometreToAKilometreHaveTheSameDigits)
{
  Random random(8802);
  const std::vector<Vector3> directions = ExtremeDirections(test::RandomDirection(random));
  for (const int degree : {12, 40})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    for (const int exponent : {-25, 15}) // 20 mm become 6e-7 mm and 7e5 mm
    {
      std::vector<double> coefficients = model.Coefficients();
      for (double& c : coefficients)
      {
        c = std::ldexp(c, exponent);
      }
      const RadialModel scaled(degree, coefficients, model.CenterWorld());
      for (const Vector3& u : directions)
      {
        const auto expected = model.EvaluateSecondOrder(u);
        const auto sample = scaled.EvaluateSecondOrder(u);
        const double scale = std::ldexp(1.0, exponent);
        EXPECT_EQ(sample.Radius, scale * expected.Radius);
        EXPECT_EQ(sample.SurfaceGradient, scale * expected.SurfaceGradient);
        EXPECT_EQ(sample.SurfaceHessian, scale * expected.SurfaceHessian);
        EXPECT_EQ(scaled.Normal(u), model.Normal(u));
      }
      // Volumes and areas are sums of such numbers, in another order of magnitude.
      EXPECT_NEAR(std::ldexp(VolumeOf(scaled), -3 * exponent) / VolumeOf(model), 1.0, 1e-14);
      EXPECT_NEAR(std::ldexp(AreaOf(scaled), -2 * exponent) / AreaOf(model), 1.0, 1e-14);
    }
  }
}

TEST(HarmonicExtremes, PointTenMetresAwayIsOnlyRounded)
{
  Random random(8803);
  const RadialModel here = test::RandomOrgan(random, 12);
  const RadialModel there(12, here.Coefficients(), {1e4, -1e4, 1e4});
  const double ulp = std::numeric_limits<double>::epsilon() * 1e4;
  for (const Vector3& u : ExtremeDirections(test::RandomDirection(random)))
  {
    EXPECT_EQ(there.Radius(u), here.Radius(u));
    EXPECT_EQ(there.Normal(u), here.Normal(u));
    // One rounding per coordinate when the centre is added.
    const Vector3 fromCenter = there.PointWorld(u) - there.CenterWorld();
    EXPECT_LE((fromCenter - here.Radius(u) * u).lpNorm<Eigen::Infinity>(), ulp);
  }
}

// Degree l is 10^(-l) or 10^(l - 12) of 20 mm: twelve decades, falling or rising.
TEST(HarmonicExtremes, TwelveDecadesBetweenDegreesLoseOnlyRoundingOfTheLargest)
{
  constexpr int Degree = 12;
  Random random(8804);
  for (const bool isRising : {false, true})
  {
    std::vector<double> coefficients = test::RandomCoefficients(random, Degree);
    for (int l = 0; l <= Degree; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        coefficients[SphericalHarmonicBasis::Index(l, m)] *=
            20.0 * std::pow(10.0, isRising ? l - Degree : -l);
      }
    }
    const RadialEvaluator evaluator(Degree, coefficients);
    const SphericalHarmonicBasis basis(Degree);
    const test::ReferenceScale scale(Degree, coefficients);
    std::vector<double> values(basis.Size());
    for (const Vector3& u : ExtremeDirections(test::RandomDirection(random)))
    {
      basis.Evaluate(u, values.data());
      long double exact = 0.0L;
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        exact += static_cast<long double>(values[k]) * coefficients[k];
      }
      // The documented error of either side.
      EXPECT_NEAR(evaluator.Radius(u), static_cast<double>(exact), 2e-14 * scale.Radius);
    }
  }
}

// Coefficients of 1e150 mm, one order at a time: columns start at 1e-300 and below near a pole.
TEST(HarmonicExtremes, NoOrderOfDegree2000OverflowsOrIsLost)
{
  const SphericalHarmonicBasis basis(HighestDegree);
  std::vector<double> values(basis.Size());
  std::vector<double> coefficients(basis.Size(), 0.0);
  for (const int order : {0, 1, 700, -1500, HighestDegree})
  {
    const std::size_t index = SphericalHarmonicBasis::Index(HighestDegree, order);
    coefficients[index] = 1e150;
    const RadialEvaluator evaluator(HighestDegree, coefficients);
    coefficients[index] = 0.0;
    for (const double sine : {1e-4, 0.3, 0.6, 0.99})
    {
      const Vector3 u(sine * 0.8, sine * 0.6, std::sqrt((1.0 - sine) * (1.0 + sine)));
      basis.Evaluate(u, values.data());
      // Two methods, each accurate to 2e-12 of the largest value of a harmonic of degree 2000,
      // which is 18.
      EXPECT_NEAR(evaluator.Radius(u) * 1e-150, values[index], 2.0 * 2e-12 * 18.0)
          << order << ' ' << sine;
    }
  }
}
} // namespace
} // namespace palpate::harmonic_extremes_test
