#include "RadialSpectrum.h"

#include "RandomShapes.h"
#include "SphericalHarmonicBasis.h"
#include "WorstCase.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::spherical_harmonic_spectrum_test
{
namespace
{
using test::Random;
using Sample = RadialModel::Sample;

const Vector3 Pole(0.0, 0.0, 1.0);

// A model with coefficients of one or more orders only, given by degree.
template <typename Fill>
RadialModel Aligned(int degree, Fill fill)
{
  std::vector<double> c(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  for (int l = 1; l <= degree; ++l)
  {
    fill(l, c.data() + SphericalHarmonicBasis::Index(l, 0));
  }
  return {degree, c, Vector3::Zero()};
}

Vector3 Along(const Vector3& u, const Vector3& tangent, double angle)
{
  return std::cos(angle) * u + std::sin(angle) * tangent;
}

// Second derivative along a great circle, from gradients.
double Bend(const RadialModel& model, const Vector3& u, const Vector3& tangent)
{
  constexpr double H = 1e-5; // rad
  const auto slope = [&](double angle)
  {
    const Vector3 here = Along(u, tangent, angle);
    return model.Evaluate(here).SurfaceGradient.dot(Along(tangent, -u, angle));
  };
  return (slope(H) - slope(-H)) / (2.0 * H);
}

TEST(RadialSpectrum, BoundsHoldEverywhere)
{
  Random random(401);
  for (const int degree : {0, 1, 2, 7, 12, 30})
  {
    const RadialModel model(degree, test::RandomCoefficients(random, degree, 1.0), Vector3::Zero());
    const RadialSpectrum spectrum(model);
    for (const Vector3& u : test::RandomDirections(random, 300))
    {
      const Sample sample = model.Evaluate(u);
      EXPECT_LE(std::abs(sample.Radius - spectrum.MeanRadius()),
                spectrum.Relief() + spectrum.EvaluationError());
      // Gradients are evaluated with errors of about 1e-14 of the bound.
      EXPECT_LE(sample.SurfaceGradient.norm(), spectrum.Slope() * (1 + 1e-12) + 1e-13);
      // The difference's own error is some 1e-9 of the bound.
      EXPECT_LE(std::abs(Bend(model, u, u.unitOrthogonal())),
                spectrum.SecondDerivative() * (1 + 1e-6) + 1e-8);
    }
  }
}

TEST(RadialSpectrum, ReliefIsSharp)
{
  // At the pole only order 0 is not zero.
  const RadialModel model = Aligned(14, [](int l, double* c) { c[0] = 1.0 / l; });
  const RadialSpectrum spectrum(model);
  EXPECT_NEAR(model.Radius(Pole) / spectrum.Relief(), 1.0, 1e-13); // rounding
}

TEST(RadialSpectrum, SlopeIsSharp)
{
  // At the pole only order 1 has a slope along x.
  const RadialModel model = Aligned(14, [](int l, double* c) { c[1] = 1.0 / l; });
  const RadialSpectrum spectrum(model);
  EXPECT_NEAR(model.Evaluate(Pole).SurfaceGradient.x() / spectrum.Slope(), 1.0, 1e-13);
}

TEST(RadialSpectrum, SecondDerivativeIsSharp)
{
  // At the pole orders 0 and 2 bend along x, by -k / 2 and sqrt(k (k - 2) / 8).
  const RadialModel model = Aligned(14,
                                    [](int l, double* c)
                                    {
                                      const double k = l * (l + 1.0);
                                      c[0] = -0.5 * k;
                                      if (l >= 2)
                                      {
                                        c[2] = std::sqrt(k * (k - 2.0) / 8.0);
                                      }
                                    });
  const RadialSpectrum spectrum(model);
  // Differences: H^2 times the fourth derivative, 1e-10 * 14^2 relative.
  EXPECT_NEAR(Bend(model, Pole, Vector3::UnitX()) / spectrum.SecondDerivative(), 1.0, 1e-7);
}

TEST(RadialSpectrum, EnclosesRadiiAndSlopesAroundDirection)
{
  Random random(403);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (const int degree : {0, 1, 5, 12, 24})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    const RadialSpectrum spectrum(model);
    for (const Vector3& u : test::RandomDirections(random, 40))
    {
      const Sample sample = model.Evaluate(u);
      for (const double angle : {0.0, 1e-9, 1e-3, 0.03, 0.3, 3.0})
      {
        const RadiusInterval radius = spectrum.RadiusAround(sample, angle);
        const double slope = spectrum.SlopeAround(sample, angle);
        for (int k = 0; k < 20; ++k)
        {
          const Vector3 tangent = u.cross(test::RandomDirection(random)).normalized();
          const Sample near = model.Evaluate(Along(u, tangent, angle * part(random)).normalized());
          EXPECT_GE(near.Radius, radius.Lower);
          EXPECT_LE(near.Radius, radius.Upper);
          EXPECT_LE(near.SurfaceGradient.norm(), slope);
        }
      }
    }
  }
}

TEST(RadialSpectrum, IsTightAroundDirection)
{
  Random random(404);
  const RadialModel model = test::RandomOrgan(random, 12);
  const RadialSpectrum spectrum(model);
  for (const Vector3& u : test::RandomDirections(random, 40))
  {
    const Sample sample = model.Evaluate(u);
    constexpr double Angle = 1e-4;
    const RadiusInterval radius = spectrum.RadiusAround(sample, Angle);
    const double slope = sample.SurfaceGradient.norm();
    // First order is exact; the rest is the bound of the second derivative and the evaluation
    // error.
    const double rest = spectrum.SecondDerivative() * Angle * Angle + 1e-8;
    EXPECT_LE(radius.Upper - radius.Lower, 2.0 * slope * Angle + rest);
  }
}

TEST(RadialSpectrum, BoundsScaleBeyondRangeOfSquares)
{
  Random random(405);
  const std::vector<double> c = test::RandomCoefficients(random, 6);
  const RadialSpectrum plain({6, c, Vector3::Zero()});
  for (const int power : {-900, 900})
  {
    std::vector<double> scaled = c;
    for (double& value : scaled)
    {
      value = std::ldexp(value, power);
    }
    const RadialSpectrum spectrum({6, scaled, Vector3::Zero()});
    // Scaling by a power of two is exact.
    EXPECT_EQ(spectrum.Relief(), std::ldexp(plain.Relief(), power));
    EXPECT_EQ(spectrum.Slope(), std::ldexp(plain.Slope(), power));
    EXPECT_EQ(spectrum.SecondDerivative(), std::ldexp(plain.SecondDerivative(), power));
  }
}

TEST(RadialSpectrum, IsZeroForPoint)
{
  const RadialSpectrum spectrum{RadialModel()};
  EXPECT_EQ(spectrum.Relief(), 0.0);
  EXPECT_EQ(spectrum.Slope(), 0.0);
  EXPECT_EQ(spectrum.SecondDerivative(), 0.0);
  EXPECT_EQ(spectrum.EvaluationError(), 0.0);
}

TEST(RadialSpectrum, IsNanForNonFiniteCoefficients)
{
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    const RadialModel model(2, {20.0, 1.0, bad, 1.0}, Vector3::Zero());
    const RadialSpectrum spectrum(model);
    EXPECT_TRUE(std::isnan(spectrum.Relief()));
    EXPECT_TRUE(std::isnan(spectrum.Slope()));
    EXPECT_TRUE(std::isnan(spectrum.SecondDerivative()));
    const RadiusInterval radius = spectrum.RadiusAround({20.0, Vector3::Zero()}, 0.1);
    EXPECT_TRUE(std::isnan(radius.Lower));
    EXPECT_TRUE(std::isnan(radius.Upper));
    EXPECT_TRUE(std::isnan(spectrum.SlopeAround({20.0, Vector3::Zero()}, 0.1)));
  }
}
} // namespace
} // namespace palpate::spherical_harmonic_spectrum_test
