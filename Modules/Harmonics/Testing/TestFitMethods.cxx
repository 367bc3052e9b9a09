// The two solvers of FitRadialModel against each other: moments with refinement, and the
// orthogonal factorisation.
#include "MomentSolver.h"
#include "OrthogonalSolver.h"
#include "RadialModelFit.h"

#include "FitSamples.h"
#include "SinglePrecision.h"
#include "SphericalHarmonicBasis.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::fit_methods_test
{
namespace
{
using test::Random;
using Options = RadialModelFitOptions;
using test::FitBy;

Options OfDegree(int degree)
{
  Options options;
  options.Degree = degree;
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

RadialSamples NoisyCap(unsigned seed, int degree, double capDegrees)
{
  Random random(seed);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, degree), 12);
  test::AddNoise(random, 0.3, samples);
  return capDegrees > 0.0 ? test::WithoutCap(samples, capDegrees * M_PI / 180.0) : samples;
}

TEST(FitMethods, Agree)
{
  for (const int degree : {0, 1, 3, 6, 12, 20})
  {
    for (const double cap : {0.0, 20.0})
    {
      const RadialSamples samples =
          NoisyCap(1000U + static_cast<unsigned>(degree), degree + 2, cap);
      const RadialModelFitResult fast = FitBy<MomentSolver>(samples, OfDegree(degree));
      const RadialModelFitResult slow = FitBy<OrthogonalSolver>(samples, OfDegree(degree));
      // Rounding of radii of 20 mm, times a condition of up to 200 at degree 20.
      const double tolerance = 1e-13 * slow.Condition * test::Norm(slow.Coefficients);
      EXPECT_LE(test::Distance(fast.Coefficients, slow.Coefficients), tolerance) << degree;
      EXPECT_LE(test::Distance(fast.Residuals, slow.Residuals), 1e-11) << degree;
      EXPECT_NEAR(fast.Rms / slow.Rms, 1.0, 1e-12) << degree;
      EXPECT_NEAR(fast.NoiseDeviation / slow.NoiseDeviation, 1.0, 1e-12) << degree;
      EXPECT_NEAR(fast.Condition / slow.Condition, 1.0, 1e-8) << degree;
      ASSERT_EQ(fast.RmsByDegree.size(), slow.RmsByDegree.size());
      for (std::size_t l = 0; l < fast.RmsByDegree.size(); ++l)
      {
        EXPECT_NEAR(fast.RmsByDegree[l] / slow.RmsByDegree[l], 1.0, 1e-10) << degree << " " << l;
      }
    }
  }
}

TEST(FitMethods, AgreeWithPenalty)
{
  for (const double cap : {0.0, 45.0})
  {
    for (const double roughness : {1e-8, 1e-4, 1e2})
    {
      const RadialSamples samples = NoisyCap(1100, 12, cap);
      Options options = OfDegree(12);
      options.PenaltyKind = Options::Penalty::Given;
      options.Roughness = roughness;
      const RadialModelFitResult fast = FitBy<MomentSolver>(samples, options);
      const RadialModelFitResult slow = FitBy<OrthogonalSolver>(samples, options);
      // The weakest penalty leaves a condition of 2e3.
      EXPECT_LE(test::Distance(fast.Coefficients, slow.Coefficients), 1e-9);
      EXPECT_NEAR(fast.DegreesOfFreedom / slow.DegreesOfFreedom, 1.0, 1e-8);
      EXPECT_NEAR(fast.Rms / slow.Rms, 1.0, 1e-10);
      const std::vector<double> values(169, 1.0);
      EXPECT_NEAR(fast.Covariance.RadiusDeviation(values.data()) /
                      slow.Covariance.RadiusDeviation(values.data()),
                  1.0, 1e-8);
    }
  }
}

TEST(FitMethods, ChooseSameStrengthByCrossValidation)
{
  const RadialSamples samples = NoisyCap(1110, 12, 45.0);
  Options options = OfDegree(12);
  options.PenaltyKind = Options::Penalty::GeneralisedCrossValidation;
  const RadialModelFitResult fast = FitBy<MomentSolver>(samples, options);
  const RadialModelFitResult slow = FitBy<OrthogonalSolver>(samples, options);
  // The search ends within a thousandth on both sides.
  EXPECT_NEAR(fast.Roughness / slow.Roughness, 1.0, 2e-3);
}

TEST(FitMethods, RefinedMomentsAreAsAccurateAsOrthogonal)
{
  Random random(1120);
  const RadialModel truth = test::RandomOrgan(random, 12);
  const RadialSamples sphere = test::SamplesOf(truth, 20);
  // Conditions of 80, 2e3 and 8e4; one step without refinement leaves 1e-6 in the last.
  for (const double cap : {30.0, 45.0, 60.0})
  {
    const RadialSamples samples = test::WithoutCap(sphere, cap * M_PI / 180.0);
    const RadialModelFitResult fit = FitBy<MomentSolver>(samples, OfDegree(12));
    // The requirement at a condition of 1e5: the radii's own rounding, 1e-16, times the condition,
    // distributed over all samples.
    EXPECT_LE(test::Distance(fit.Coefficients, truth.Coefficients()),
              1e-12 * test::Norm(truth.Coefficients()))
        << cap;
    EXPECT_LE(fit.Rms, 1e-13) << cap;
  }
}

TEST(FitMethods, AutomaticUsesOrthogonalAboveLimit)
{
  Random random(1130);
  const RadialModel truth = test::RandomOrgan(random, 12);
  const RadialSamples sphere = test::SamplesOf(truth, 20);
  const RadialSamples narrow = test::WithoutCap(sphere, 68.0 * M_PI / 180.0);
  const RadialModelFitResult below = Fit(narrow, OfDegree(12));
  EXPECT_LT(below.Condition, 1e6);
  EXPECT_EQ(below.Coefficients, FitBy<MomentSolver>(narrow, OfDegree(12)).Coefficients);
  const RadialSamples wide = test::WithoutCap(sphere, 70.0 * M_PI / 180.0);
  const RadialModelFitResult above = Fit(wide, OfDegree(12));
  EXPECT_GT(above.Condition, 1e6);
  EXPECT_EQ(above.Coefficients, FitBy<OrthogonalSolver>(wide, OfDegree(12)).Coefficients);
  for (const auto* result : {&below, &above})
  {
    // 1e-16 times a condition of 1e6.
    EXPECT_LE(test::Distance(result->Coefficients, truth.Coefficients()),
              1e-10 * test::Norm(truth.Coefficients()));
  }
}

TEST(FitMethods, MomentsFailAboveLimit)
{
  Random random(1130);
  const RadialSamples samples =
      test::WithoutCap(test::SamplesOf(test::RandomOrgan(random, 12), 20), 70.0 * M_PI / 180.0);
  RadialModelFitResult result;
  const Options options = OfDegree(12);
  MomentSolver solver(12);
  FitRun run(samples, options, solver);
  const Status status = run.Run(result);
  EXPECT_FALSE(run.Able());
  EXPECT_NE(status.Message().find("method of moments"), std::string::npos) << status.Message();
}

TEST(FitMethods, AutomaticFitsUnderdeterminedPenalisedProblem)
{
  // All on one half: singular to rounding without the penalty.
  Random random(1140);
  const RadialModel truth = test::RandomOrgan(random, 4);
  const RadialSamples samples = test::WithoutCap(test::SamplesOf(truth, 14), 100.0 * M_PI / 180.0);
  Options options = OfDegree(12);
  options.PenaltyKind = Options::Penalty::Given;
  options.Roughness = 1e-6;
  const RadialModelFitResult fit = Fit(samples, options);
  EXPECT_LT(fit.Rms, 0.1); // the samples are exact, the penalty weak
  for (const double c : fit.Coefficients)
  {
    EXPECT_LT(std::abs(c), 100.0); // sqrt(4 pi) times 20 mm for the largest
  }
}

TEST(FitMethods, ReusedSolverReproducesBits)
{
  MomentSolver solver(8);
  const Options options = OfDegree(8);
  for (unsigned seed = 1150; seed < 1153; ++seed)
  {
    const RadialSamples samples = NoisyCap(seed, 8, seed == 1151 ? 20.0 : 0.0);
    RadialModelFitResult result;
    ASSERT_TRUE(FitRun(samples, options, solver).Run(result).IsOk());
    EXPECT_EQ(result.Coefficients, Fit(samples, options).Coefficients);
  }
}

TEST(FitMethods, ReusedSolverRecoversFromOverflow)
{
  MomentSolver solver(8);
  const Options options = OfDegree(8);
  const RadialSamples good = NoisyCap(1155, 8, 0.0);
  RadialSamples huge = good;
  huge.Radii.assign(huge.Radii.size(), 1e308);
  RadialModelFitResult result;
  EXPECT_FALSE(FitRun(huge, options, solver).Run(result).IsOk());
  ASSERT_TRUE(FitRun(good, options, solver).Run(result).IsOk());
  EXPECT_EQ(result.Coefficients, Fit(good, options).Coefficients);
}

TEST(FitMethods, FitIsIndependentOfWeightScale)
{
  RadialSamples samples = NoisyCap(1160, 6, 0.0);
  const RadialModelFitResult fit = Fit(samples, OfDegree(6));
  for (const double scale : {1e-280, 1e300})
  {
    RadialSamples scaled = samples;
    for (double& weight : scaled.Weights)
    {
      weight *= scale;
    }
    const RadialModelFitResult other = Fit(scaled, OfDegree(6));
    EXPECT_LE(test::Distance(fit.Coefficients, other.Coefficients), 1e-11) << scale;
    EXPECT_NEAR(other.Rms / fit.Rms, 1.0, 1e-11) << scale;
  }
}

TEST(FitMethods, AcceptsSinglePrecisionDirections)
{
  RadialSamples samples = NoisyCap(1170, 12, 30.0);
  for (Vector3& direction : samples.Directions)
  {
    direction = test::InSinglePrecision(direction);
  }
  const RadialModelFitResult fast = FitBy<MomentSolver>(samples, OfDegree(12));
  const RadialModelFitResult slow = FitBy<OrthogonalSolver>(samples, OfDegree(12));
  EXPECT_LE(test::Distance(fast.Coefficients, slow.Coefficients),
            1e-11 * test::Norm(slow.Coefficients));
}

TEST(FitMethods, ZeroRadiiGiveZeroCoefficients)
{
  RadialSamples samples = NoisyCap(1180, 4, 0.0);
  samples.Radii.assign(samples.Radii.size(), 0.0);
  for (const RadialModelFitResult& fit :
       {FitBy<MomentSolver>(samples, OfDegree(4)), FitBy<OrthogonalSolver>(samples, OfDegree(4))})
  {
    EXPECT_EQ(test::Norm(fit.Coefficients), 0.0);
    EXPECT_EQ(fit.Rms, 0.0);
  }
}
} // namespace
} // namespace palpate::fit_methods_test
