// Fits from samples that hardly determine them, or that have errors of up to a voxel.
#include "DirectionCoverage.h"
#include "FitPrecision.h"
#include "FitSamples.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::fit_extremes_test
{
namespace
{
using test::HardDirections;
using test::Random;
using test::WorstCase;
using Options = RadialModelFitOptions;

constexpr int Degree = 12;
constexpr double Voxel = 1.0; // mm

Options Unlimited(Options::Penalty penalty)
{
  Options options;
  options.Degree = Degree;
  options.PenaltyKind = penalty;
  options.MaximumCondition = std::numeric_limits<double>::infinity();
  return options;
}

RadialModelFitResult Fit(const RadialSamples& samples, const Options& options)
{
  RadialModelFitResult result;
  const Status status = FitRadialModel(samples, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

// Measured once for all tests below.
const std::vector<test::FitPrecision>& Precision()
{
  static const std::vector<test::FitPrecision> rows = test::MeasureFitPrecision();
  return rows;
}

TEST(FitExtremes, DoublePrecisionLosesOnlyTheCondition)
{
  for (const test::FitPrecision& row : Precision())
  {
    // Radii of 20 mm have rounding errors of 2e-15, which the condition multiplies; a penalty
    // removes the condition, except for the data that fill the gap.
    const double bound = 1e-14 * 20.0 * (row.Roughness > 0.0 ? 100.0 : 1.0 + row.Condition);
    EXPECT_LE(row.Ours, bound) << row.Directions << ' ' << row.Roughness;
  }
}

TEST(FitExtremes, SinglePrecisionFailsForMissingDirections)
{
  constexpr double Felt = 0.01; // mm
  int broken = 0;
  for (const test::FitPrecision& row : Precision())
  {
    // The same for float's rounding of 6e-8, with the condition squared by the normal equations.
    const bool isHopeless = row.Roughness == 0.0 && row.Condition > 1e3;
    if (isHopeless)
    {
      EXPECT_FALSE(row.FloatNormalEquations <= Felt) << row.Directions;
      ++broken;
    }
    if (row.Condition < 10.0)
    {
      EXPECT_LE(row.FloatNormalEquations, Felt) << row.Directions;
      EXPECT_LE(row.FloatOrthogonal, Felt) << row.Directions;
    }
  }
  EXPECT_GE(broken, 3);
}

RadialSamples NoisySamples(const HardDirections& hard, const RadialModel& organ, double noise,
                           unsigned seed)
{
  Random random(seed);
  RadialSamples samples = test::SamplesAlong(hard, organ);
  if (noise > 0.0)
  {
    test::AddNoise(random, noise, samples);
  }
  return samples;
}

// Largest ratio of the radius error to its stated deviation, over the whole sphere.
double LargestSurprise(const RadialSamples& samples, const RadialModel& organ)
{
  const RadialModelFitResult fit = Fit(samples, Unlimited(Options::Penalty::None));
  const RadialModel fitted(Degree, fit.Coefficients, Vector3::Zero());
  const SphericalHarmonicBasis basis(Degree);
  std::vector<double> values(basis.Size());
  WorstCase surprise;
  const IcosahedronDirections sphere(6);
  for (const Vector3& u : sphere.Directions())
  {
    basis.Evaluate(u, values.data());
    surprise.Add((fitted.Radius(u) - organ.Radius(u)) /
                 fit.Covariance.RadiusDeviation(values.data()));
  }
  return surprise.Value();
}

// In a gap the error is large, and the fit reports it.
TEST(FitExtremes, ErrorsStayWithinStatedDeviationForAnyDirections)
{
  Random random(8840);
  const RadialModel organ = test::RandomOrgan(random, Degree);
  for (const HardDirections& hard : test::AllHardDirections())
  {
    if (hard.Directions.size() == 169)
    {
      continue; // nothing is left to estimate the noise from
    }
    for (const double noise : {0.01, 0.3, Voxel})
    {
      // Of some hundred independent numbers, five deviations are exceeded in one of 10,000 fits.
      EXPECT_LE(LargestSurprise(NoisySamples(hard, organ, noise, 8841), organ), 5.0)
          << hard.Name << ' ' << noise;
    }
  }
}

TEST(FitExtremes, PenaltyFillsGapsWithinTheOrgansRelief)
{
  Random random(8842);
  const RadialModel organ = test::RandomOrgan(random, Degree);
  const IcosahedronDirections sphere(12);
  WorstCase relief;
  for (const Vector3& u : sphere.Directions())
  {
    relief.Add(organ.Radius(u) - 20.0);
  }
  for (const HardDirections& hard : test::AllHardDirections())
  {
    for (const double noise : {0.0, 0.3, Voxel})
    {
      const Options options = Unlimited(Options::Penalty::GeneralisedCrossValidation);
      const auto fit = Fit(NoisySamples(hard, organ, noise, 8843), options);
      const RadialModel fitted(Degree, fit.Coefficients, Vector3::Zero());
      WorstCase error;
      for (const Vector3& u : sphere.Directions())
      {
        error.Add(fitted.Radius(u) - organ.Radius(u));
      }
      // No worse than a sphere of the mean radius would be.
      EXPECT_LE(error.Value(), relief.Value()) << hard.Name << ' ' << noise;
    }
  }
}

TEST(FitExtremes, RejectsUndeterminedFitsAndSuggestsAPenalty)
{
  Random random(8844);
  const RadialModel organ = test::RandomOrgan(random, Degree);
  for (const HardDirections& hard : test::AllHardDirections())
  {
    const RadialSamples samples = test::SamplesAlong(hard, organ);
    const double condition = Fit(samples, Unlimited(Options::Penalty::None)).Condition;
    RadialModelFitResult result;
    const Status status = FitRadialModel(samples, Options(), result);
    EXPECT_EQ(status.IsOk(), condition <= Options().MaximumCondition) << hard.Name;
    EXPECT_EQ(status.IsOk(), status.Message().find("add a roughness penalty") == std::string::npos)
        << status.Message();
  }
}

// As many samples as coefficients: the model interpolates all of them, including noise.
TEST(FitExtremes, MinimalFitInterpolatesAndOneSampleLessIsRejected)
{
  Random random(8845);
  const RadialModel organ = test::RandomOrgan(random, Degree);
  RadialSamples samples = NoisySamples(test::AllHardDirections().back(), organ, Voxel, 8846);
  ASSERT_EQ(samples.Radii.size(), 169U);
  const auto fit = Fit(samples, Unlimited(Options::Penalty::None));
  EXPECT_LE(fit.Rms, 1e-14 * 20.0 * fit.Condition);
  samples.Directions.pop_back();
  samples.Radii.pop_back();
  samples.Weights.pop_back();
  RadialModelFitResult result;
  EXPECT_FALSE(FitRadialModel(samples, Unlimited(Options::Penalty::None), result).IsOk());
}

// Contradicting samples along one direction count as their mean.
TEST(FitExtremes, RepeatedSamplesCountAsTheirMean)
{
  Random random(8847);
  const RadialModel organ = test::RandomOrgan(random, Degree);
  RadialSamples many = test::SamplesOf(organ, 8);
  RadialSamples one = many;
  const Vector3 u = many.Directions[100];
  std::normal_distribution<double> noise(0.0, 5.0 * Voxel);
  double sum = 0.0;
  for (int n = 0; n < 1000; ++n)
  {
    many.Directions.push_back(u);
    many.Radii.push_back(20.0 + noise(random));
    many.Weights.push_back(0.001);
    sum += many.Radii.back();
  }
  one.Directions.push_back(u);
  one.Radii.push_back(sum / 1000.0);
  one.Weights.push_back(1.0);
  const Options options = Unlimited(Options::Penalty::None);
  // Rounding of sums of a thousand numbers of 20 mm.
  EXPECT_LE(test::Distance(Fit(many, options).Coefficients, Fit(one, options).Coefficients), 1e-11);
}

// 10^-6 mm to 10^6 mm, by powers of two, so that every digit must be the same.
TEST(FitExtremes, RadiiOfAnySizeGiveTheSameFit)
{
  Random random(8848);
  const RadialModel organ = test::RandomOrgan(random, Degree);
  const RadialSamples samples = NoisySamples(test::AllHardDirections()[3], organ, 0.3, 8849);
  const Options options = Unlimited(Options::Penalty::GeneralisedCrossValidation);
  const auto expected = Fit(samples, options);
  for (const int exponent : {-25, 15})
  {
    RadialSamples scaled = samples;
    for (double& radius : scaled.Radii)
    {
      radius = std::ldexp(radius, exponent);
    }
    const auto fit = Fit(scaled, options);
    EXPECT_EQ(fit.Roughness, expected.Roughness);
    EXPECT_EQ(fit.Rms, std::ldexp(expected.Rms, exponent));
    for (std::size_t k = 0; k < fit.Coefficients.size(); ++k)
    {
      ASSERT_EQ(fit.Coefficients[k], std::ldexp(expected.Coefficients[k], exponent)) << k;
    }
  }
}

// Degree l is 10^-l of the mean: values below rounding of the largest are lost.
TEST(FitExtremes, FitsTwelveDecadesBetweenDegreesToRoundingOfTheLargest)
{
  Random random(8850);
  std::vector<double> coefficients = test::RandomCoefficients(random, Degree);
  for (int l = 0; l <= Degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      coefficients[SphericalHarmonicBasis::Index(l, m)] *= 20.0 * std::pow(10.0, -l);
    }
  }
  const RadialModel model(Degree, coefficients, Vector3::Zero());
  const auto fit = Fit(test::SamplesOf(model, 12), Unlimited(Options::Penalty::None));
  WorstCase off;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
  {
    off.Add(fit.Coefficients[k] - coefficients[k]);
  }
  // A rounding of 20 mm per sample, averaged over 1,442 of them; at degree 12 coefficients are
  // 2e-11.
  EXPECT_LE(off.Value(), 1e-14 * test::Norm(coefficients));
}
} // namespace
} // namespace palpate::fit_extremes_test
