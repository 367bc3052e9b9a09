#include "FixedDirectionFit.h"

#include "FitSamples.h"
#include "SphericalHarmonicFit.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::Random;

RadialSamples Samples(unsigned seed, double cap = 0.0)
{
  Random random(seed);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 12), 14);
  test::AddNoise(random, 0.3, samples);
  return cap > 0.0 ? test::WithoutCap(samples, cap) : samples;
}

std::vector<double> Fit(const RadialSamples& samples, int degree, double strength)
{
  SphericalHarmonicFitOptions options;
  options.Degree = degree;
  options.PenaltyKind = strength > 0.0 ? SphericalHarmonicFitOptions::Penalty::Given
                                       : SphericalHarmonicFitOptions::Penalty::None;
  options.Roughness = strength;
  SphericalHarmonicFitResult result;
  const Status status = FitSphericalHarmonics(samples, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result.Coefficients;
}

TEST(FixedDirectionFit, GivesTheCoefficientsOfAFreshFit)
{
  for (const double strength : {0.0, 1e-4})
  {
    for (const int degree : {0, 3, 12})
    {
      const RadialSamples first = Samples(1400);
      FixedDirectionFit fixed;
      ASSERT_TRUE(fixed.Prepare(first.Directions, first.Weights, degree, strength).IsOk());
      ASSERT_EQ(fixed.SampleCount(), first.Radii.size());
      FixedDirectionFit::Scratch scratch = fixed.MakeScratch();
      std::vector<double> coefficients(fixed.CoefficientCount());
      for (unsigned seed = 1401; seed < 1404; ++seed)
      {
        const RadialSamples samples = Samples(seed);
        ASSERT_TRUE(fixed.Refit(samples.Radii.data(), scratch, coefficients.data()));
        // Radii of 20 mm, a condition near one: some hundred roundings of 70 mm.
        EXPECT_LE(test::Distance(coefficients, Fit(samples, degree, strength)), 1e-11);
      }
    }
  }
}

TEST(FixedDirectionFit, LosesTheSquareOfTheConditionWithoutRefinement)
{
  // A cap of 40 degrees is missing: a condition of 700.
  const RadialSamples samples = Samples(1410, 40.0 * M_PI / 180.0);
  FixedDirectionFit fixed;
  ASSERT_TRUE(fixed.Prepare(samples.Directions, samples.Weights, 12, 0.0).IsOk());
  FixedDirectionFit::Scratch scratch = fixed.MakeScratch();
  std::vector<double> coefficients(fixed.CoefficientCount());
  ASSERT_TRUE(fixed.Refit(samples.Radii.data(), scratch, coefficients.data()));
  const std::vector<double> exact = Fit(samples, 12, 0.0);
  EXPECT_LE(test::Distance(coefficients, exact), 1e-15 * 700 * 700 * test::Norm(exact));
}

TEST(FixedDirectionFit, AScratchOfItsOwnMakesCallsIndependent)
{
  const RadialSamples a = Samples(1420);
  const RadialSamples b = Samples(1421);
  FixedDirectionFit fixed;
  ASSERT_TRUE(fixed.Prepare(a.Directions, a.Weights, 6, 0.0).IsOk());
  const FixedDirectionFit& shared = fixed;
  FixedDirectionFit::Scratch one = shared.MakeScratch();
  FixedDirectionFit::Scratch two = shared.MakeScratch();
  std::vector<double> first(49);
  std::vector<double> second(49);
  std::vector<double> again(49);
  ASSERT_TRUE(shared.Refit(a.Radii.data(), one, first.data()));
  ASSERT_TRUE(shared.Refit(b.Radii.data(), two, second.data()));
  ASSERT_TRUE(shared.Refit(a.Radii.data(), two, again.data()));
  EXPECT_EQ(first, again);
  EXPECT_NE(first, second);
}

TEST(FixedDirectionFit, LeavesTheCoefficientsAloneWhereARadiusIsNotFinite)
{
  const RadialSamples good = Samples(1430);
  FixedDirectionFit fixed;
  ASSERT_TRUE(fixed.Prepare(good.Directions, good.Weights, 4, 0.0).IsOk());
  FixedDirectionFit::Scratch scratch = fixed.MakeScratch();
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
  {
    std::vector<double> radii = good.Radii;
    radii[radii.size() - 1] = bad;
    std::vector<double> coefficients(25, 7.0);
    EXPECT_FALSE(fixed.Refit(radii.data(), scratch, coefficients.data()));
    EXPECT_EQ(coefficients, std::vector<double>(25, 7.0));
    // And the next call is well again.
    EXPECT_TRUE(fixed.Refit(good.Radii.data(), scratch, coefficients.data()));
    EXPECT_LE(test::Distance(coefficients, Fit(good, 4, 0.0)), 1e-11);
  }
}

TEST(FixedDirectionFit, RefusesWhatDoesNotDetermineTheDegree)
{
  const RadialSamples samples = Samples(1440, 60.0 * M_PI / 180.0);
  FixedDirectionFit fixed;
  EXPECT_NE(fixed.Prepare(samples.Directions, samples.Weights, 12, 0.0).Message().find("penalty"),
            std::string::npos);
  EXPECT_EQ(fixed.SampleCount(), 0U);
  EXPECT_TRUE(fixed.Prepare(samples.Directions, samples.Weights, 12, 1e-4).IsOk());
  EXPECT_FALSE(fixed.Prepare(samples.Directions, samples.Weights, 60, 1e-4).IsOk());
  EXPECT_FALSE(fixed.Prepare(samples.Directions, samples.Weights, -1, 0.0).IsOk());
  EXPECT_FALSE(fixed.Prepare(samples.Directions, {}, 3, 0.0).IsOk());
  for (const double bad : {-1e-9, std::nan(""), HUGE_VAL})
  {
    EXPECT_FALSE(fixed.Prepare(samples.Directions, samples.Weights, 3, bad).IsOk()) << bad;
  }
}
} // namespace
} // namespace palpate
