// The roughness penalty of FitRadialModel, its choice, and the covariance of the fit.
#include "RadialModelFit.h"

#include "FitSamples.h"
#include "RadialModel.h"
#include "SphericalHarmonicBasis.h"

#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace palpate::spherical_harmonic_penalty_test
{
namespace
{
using test::Random;
using Options = RadialModelFitOptions;

RadialModelFitResult Fit(const RadialSamples& samples, const Options& options)
{
  RadialModelFitResult result;
  const Status status = FitRadialModel(samples, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

Options Unpenalised(int degree)
{
  Options options;
  options.Degree = degree;
  return options;
}

Options WithRoughness(int degree, double roughness)
{
  Options options = Unpenalised(degree);
  options.PenaltyKind = Options::Penalty::Given;
  options.Roughness = roughness;
  return options;
}

Options CrossValidated(int degree)
{
  Options options = Unpenalised(degree);
  options.PenaltyKind = Options::Penalty::GeneralisedCrossValidation;
  return options;
}

RadialSamples NoisySamples(Random& random, const RadialModel& truth, double deviation)
{
  RadialSamples samples = test::SamplesOf(truth, 8);
  test::AddNoise(random, deviation, samples);
  return samples;
}

// The documented objective of the penalised fit.
double Objective(const RadialSamples& samples, int degree, double roughness,
                 const std::vector<double>& coefficients)
{
  const RadialModel model(degree, coefficients, Vector3::Zero());
  double squares = 0.0;
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    const double residual = samples.Radii[i] - model.Radius(samples.Directions[i]);
    squares += samples.Weights[i] * residual * residual;
  }
  const double total = std::accumulate(samples.Weights.begin(), samples.Weights.end(), 0.0);
  double penalty = 0.0;
  for (int l = 0; l <= degree; ++l)
  {
    penalty += std::pow(l * (l + 1.0), 2) * model.PowerSpectrum()[static_cast<std::size_t>(l)];
  }
  return 4 * M_PI * squares / total + roughness * penalty;
}

TEST(RadialModelPenalty, SolutionMinimisesDocumentedObjective)
{
  Random random(601);
  const RadialModel truth = test::RandomOrgan(random, 8);
  const RadialSamples samples = NoisySamples(random, truth, 0.5);
  for (const double roughness : {1e-5, 1e-3, 1e-1})
  {
    const std::vector<double> best = Fit(samples, WithRoughness(6, roughness)).Coefficients;
    const double least = Objective(samples, 6, roughness, best);
    for (int trial = 0; trial < 50; ++trial)
    {
      std::vector<double> other = test::RandomCoefficients(random, 6);
      for (std::size_t k = 0; k < other.size(); ++k)
      {
        other[k] = best[k] + 1e-3 * other[k];
      }
      // The objective is a parabola: a step of 1e-3 in 49 coefficients costs at least about 4e-5,
      // far above its rounding.
      EXPECT_GT(Objective(samples, 6, roughness, other), least) << roughness;
    }
  }
}

TEST(RadialModelPenalty, VanishingStrengthGivesPlainFit)
{
  Random random(602);
  const RadialSamples samples = NoisySamples(random, test::RandomOrgan(random, 8), 0.5);
  const RadialModelFitResult plain = Fit(samples, Unpenalised(8));
  const RadialModelFitResult weak = Fit(samples, WithRoughness(8, 1e-16));
  // The strength times (8 * 9)^2 changes a coefficient of a few mm by 1e-12; the rest is rounding.
  EXPECT_LE(test::Distance(weak.Coefficients, plain.Coefficients), 1e-11);
  EXPECT_NEAR(weak.DegreesOfFreedom, 81.0, 1e-9);
  EXPECT_NEAR(weak.NoiseDeviation / plain.NoiseDeviation, 1.0, 1e-11);
  // A factor of the covariance is unique up to a rotation: compare the covariances.
  const Eigen::MatrixXd weakFactor = weak.Covariance.Factor();
  const Eigen::MatrixXd plainFactor = plain.Covariance.Factor();
  const Eigen::MatrixXd covariance = plainFactor * plainFactor.transpose();
  EXPECT_LE((weakFactor * weakFactor.transpose() - covariance).norm(), 1e-9 * covariance.norm());
}

TEST(RadialModelPenalty, HugeStrengthGivesSphereOfMeanRadius)
{
  Random random(603);
  const RadialSamples samples = NoisySamples(random, test::RandomOrgan(random, 8), 0.5);
  const RadialModelFitResult strong = Fit(samples, WithRoughness(8, 1e16));
  double mean = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    mean += samples.Weights[i] * samples.Radii[i];
    total += samples.Weights[i];
  }
  const double expected = mean / total * std::sqrt(4 * M_PI);
  // Shrunk by the strength: 70 mm / 1e16; then rounding.
  EXPECT_LE(test::Distance(strong.Coefficients, {expected}), 1e-12);
  EXPECT_NEAR(strong.DegreesOfFreedom, 1.0, 1e-12);
}

TEST(RadialModelPenalty, StrongerPenaltiesAreSmootherButLessClose)
{
  Random random(604);
  const RadialSamples samples = NoisySamples(random, test::RandomOrgan(random, 8), 0.5);
  double degreesOfFreedom = 82.0;
  double rms = 0.0;
  for (int exponent = -8; exponent <= 2; ++exponent)
  {
    const double roughness = std::pow(10.0, exponent);
    const RadialModelFitResult fit = Fit(samples, WithRoughness(8, roughness));
    EXPECT_EQ(fit.Roughness, roughness);
    EXPECT_LT(fit.DegreesOfFreedom, degreesOfFreedom);
    EXPECT_GT(fit.Rms, rms);
    EXPECT_TRUE(fit.RmsByDegree.empty());
    degreesOfFreedom = fit.DegreesOfFreedom;
    rms = fit.Rms;
  }
}

TEST(RadialModelPenalty, CrossValidationIsNearBestStrength)
{
  for (unsigned seed = 610; seed < 615; ++seed)
  {
    Random random(seed);
    const RadialModel truth = test::RandomOrgan(random, 12);
    const RadialSamples samples = NoisySamples(random, truth, 0.6);
    double best = std::numeric_limits<double>::infinity();
    for (int exponent = -30; exponent <= 3; ++exponent)
    {
      const double roughness = std::pow(2.0, exponent);
      best = std::min(best, test::Distance(Fit(samples, WithRoughness(12, roughness)).Coefficients,
                                           truth.Coefficients()));
    }
    const RadialModelFitResult chosen = Fit(samples, CrossValidated(12));
    const double error = test::Distance(chosen.Coefficients, truth.Coefficients());
    const double plain =
        test::Distance(Fit(samples, Unpenalised(12)).Coefficients, truth.Coefficients());
    // The choice is random; its expected loss falls with the number of samples (642). Five fixed
    // cases stay below a fifth.
    EXPECT_LE(error, 1.2 * best) << seed;
    EXPECT_LT(error, plain) << seed;
    EXPECT_GT(chosen.Roughness, 0.0);
  }
}

TEST(RadialModelPenalty, CrossValidationHardlySmoothsExactSamples)
{
  Random random(621);
  const RadialModel truth = test::RandomOrgan(random, 8);
  const RadialModelFitResult fit = Fit(test::SamplesOf(truth, 8), CrossValidated(8));
  // The weakest strength of the scan is 1e-12 of the strongest.
  EXPECT_LE(test::Distance(fit.Coefficients, truth.Coefficients()),
            1e-6 * test::Norm(truth.Coefficients()));
}

TEST(RadialModelPenalty, FillsMissingCap)
{
  Random random(622);
  const RadialModel truth = test::RandomOrgan(random, 4);
  RadialSamples samples = test::WithoutCap(test::SamplesOf(truth, 14), M_PI / 4);
  test::AddNoise(random, 0.05, samples);
  const RadialModelFitResult fit = Fit(samples, CrossValidated(12));
  const RadialModel model(12, fit.Coefficients, Vector3::Zero());
  // In the centre of the gap, 45 degrees from any sample, the radius of 20 mm stays plausible.
  EXPECT_NEAR(model.Radius({0, 0, 1}), truth.Radius({0, 0, 1}), 4.0);
}

TEST(RadialModelPenalty, RejectsNonPositiveStrength)
{
  Random random(623);
  const RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 3), 4);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
  {
    RadialModelFitResult result;
    const Status status = FitRadialModel(samples, WithRoughness(3, bad), result);
    EXPECT_NE(status.Message().find("positive"), std::string::npos) << bad;
  }
}

TEST(RadialModelPenalty, DegreeZeroGivesMean)
{
  RadialSamples samples = test::SamplesOf(RadialModel(), 2);
  samples.Radii.assign(samples.Radii.size(), 3.0);
  // sqrt(4 pi) 3 mm, rounding.
  EXPECT_NEAR(Fit(samples, WithRoughness(0, 1.0)).Coefficients[0], 3.0 * std::sqrt(4 * M_PI),
              1e-13);
}

TEST(RadialModelFitCovariance, NoiseDeviationIsUnbiased)
{
  Random random(630);
  const RadialModel truth = test::RandomOrgan(random, 6);
  constexpr double Noise = 0.4;
  constexpr int Trials = 200;
  RadialSamples exact = test::SamplesOf(truth, 5); // 252 samples, 203 degrees of freedom left
  exact.Weights.assign(exact.Radii.size(), 1.0);
  double variance = 0.0;
  for (int trial = 0; trial < Trials; ++trial)
  {
    RadialSamples samples = exact;
    test::AddNoise(random, Noise, samples);
    variance += std::pow(Fit(samples, Unpenalised(6)).NoiseDeviation, 2) / Trials;
  }
  // A mean of chi-squares with 203 * 200 degrees of freedom: deviation sqrt(2 / 40600) = 0.7 %;
  // four of them.
  EXPECT_NEAR(variance / (Noise * Noise), 1.0, 0.028);
}

// Smallest and largest ratio of the radius's spread over many noisy repetitions to the spread that
// one fit predicts, over some directions.
std::pair<double, double> SpreadOverPrediction(const Options& options, double noise, int trials)
{
  Random random(631);
  const RadialModel truth = test::RandomOrgan(random, 6);
  const RadialSamples exact = test::WithoutCap(test::SamplesOf(truth, 6), 0.6);
  const double meanWeight = std::accumulate(exact.Weights.begin(), exact.Weights.end(), 0.0) /
                            static_cast<double>(exact.Weights.size());
  const SphericalHarmonicBasis basis(options.Degree);
  std::vector<Vector3> directions = test::RandomDirections(random, 10);
  directions.push_back({0, 0, 1});
  std::vector<double> sum(directions.size(), 0.0);
  std::vector<double> squares(directions.size(), 0.0);
  std::vector<double> predicted(directions.size(), 0.0);
  std::vector<double> values(basis.Size());
  for (int trial = 0; trial < trials; ++trial)
  {
    RadialSamples samples = exact;
    for (std::size_t i = 0; i < samples.Radii.size(); ++i)
    {
      // The weights are correct if a sample's variance is inverse to its weight.
      std::normal_distribution<double> normal(0.0,
                                              noise * std::sqrt(meanWeight / exact.Weights[i]));
      samples.Radii[i] += normal(random);
    }
    const RadialModelFitResult fit = Fit(samples, options);
    const RadialModel model(options.Degree, fit.Coefficients, Vector3::Zero());
    for (std::size_t k = 0; k < directions.size(); ++k)
    {
      const double radius = model.Radius(directions[k]) - truth.Radius(directions[k]);
      sum[k] += radius / trials;
      squares[k] += radius * radius / trials;
      basis.Evaluate(directions[k], values.data());
      predicted[k] += std::pow(fit.Covariance.RadiusDeviation(values.data()), 2) / trials;
    }
  }
  std::pair<double, double> range(std::numeric_limits<double>::infinity(), 0.0);
  for (std::size_t k = 0; k < directions.size(); ++k)
  {
    const double ratio = std::sqrt((squares[k] - sum[k] * sum[k]) / predicted[k]);
    EXPECT_FALSE(std::isnan(ratio));
    range = {std::min(range.first, ratio), std::max(range.second, ratio)};
  }
  return range;
}

// The spread of n repetitions is known to 1 / sqrt(2 n) = 3.5 % for 400; four of them.
constexpr int Repetitions = 400;
constexpr double SpreadTolerance = 0.14;

TEST(RadialModelFitCovariance, RadiusDeviationMatchesSpread)
{
  const auto [smallest, largest] = SpreadOverPrediction(Unpenalised(6), 0.3, Repetitions);
  EXPECT_GT(smallest, 1.0 - SpreadTolerance);
  EXPECT_LT(largest, 1.0 + SpreadTolerance);
}

TEST(RadialModelFitCovariance, RadiusDeviationMatchesSpreadWithPenalty)
{
  const auto [smallest, largest] = SpreadOverPrediction(WithRoughness(6, 1e-4), 0.3, Repetitions);
  EXPECT_GT(smallest, 1.0 - SpreadTolerance);
  EXPECT_LT(largest, 1.0 + SpreadTolerance);
}

// Frequency with which the truth is within two deviations of a coefficient, over many repetitions.
TEST(RadialModelFitCovariance, TwoDeviationsCoverTruth)
{
  Random random(640);
  const RadialModel truth = test::RandomOrgan(random, 6);
  RadialSamples exact = test::WithoutCap(test::SamplesOf(truth, 6), 0.4);
  exact.Weights.assign(exact.Radii.size(), 1.0);
  int covered = 0;
  constexpr int Trials = 200;
  for (int trial = 0; trial < Trials; ++trial)
  {
    RadialSamples samples = exact;
    test::AddNoise(random, 0.3, samples);
    const RadialModelFitResult fit = Fit(samples, Unpenalised(6));
    const Eigen::MatrixXd factor = fit.Covariance.Factor();
    for (std::size_t k = 0; k < 49; ++k)
    {
      const double error = std::abs(fit.Coefficients[k] - truth.Coefficients()[k]);
      const double deviation = factor.row(static_cast<Eigen::Index>(k)).norm();
      covered += error <= 2.0 * deviation ? 1 : 0;
    }
  }
  // Student's t with 299 degrees of freedom: 95.36 %. 9,800 coefficients, correlated by the gap:
  // a deviation of 0.2 to 0.4 %; four of the larger.
  EXPECT_NEAR(covered / (49.0 * Trials), 0.9536, 0.016);
}

TEST(RadialModelFitCovariance, DeviationsFollowFromFactor)
{
  Random random(641);
  const RadialSamples samples =
      test::WithoutCap(NoisySamples(random, test::RandomOrgan(random, 6), 0.3), 0.4);
  for (const Options& options : {Unpenalised(6), WithRoughness(6, 1e-4)})
  {
    const RadialModelFitResult fit = Fit(samples, options);
    const Eigen::MatrixXd factor = fit.Covariance.Factor();
    const SphericalHarmonicBasis basis(6);
    Eigen::VectorXd values(49);
    basis.Evaluate(test::RandomDirection(random), values.data());
    EXPECT_NEAR(fit.Covariance.RadiusDeviation(values.data()) /
                    (factor.transpose() * values).norm(),
                1.0, 1e-11);
    EXPECT_NEAR(fit.Covariance.Trace() / factor.squaredNorm(), 1.0, 1e-11);
  }
}
} // namespace
} // namespace palpate::spherical_harmonic_penalty_test
