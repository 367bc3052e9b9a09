// Huber weights: outliers, efficiency without them, and termination.
#include "HuberWeights.h"
#include "MomentSolver.h"
#include "OrthogonalSolver.h"
#include "RadialModelFit.h"

#include "FitSamples.h"
#include "SphericalHarmonicBasis.h"

#include <gtest/gtest.h>
#include <numeric>

namespace palpate::robust_fit_test
{
namespace
{
using test::Random;
using Options = RadialModelFitOptions;

constexpr double Noise = 0.3;

Options Huber(int degree)
{
  Options options;
  options.Degree = degree;
  options.RobustKind = Options::Robust::Huber;
  return options;
}

RadialModelFitResult Fit(const RadialSamples& samples, const Options& options)
{
  RadialModelFitResult result;
  const Status status = FitRadialModel(samples, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

// Adds 5 to 15 mm outwards to a fraction of the samples.
void AddOutliers(Random& random, double part, RadialSamples& samples)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (double& radius : samples.Radii)
  {
    if (uniform(random) < part)
    {
      radius += 5.0 + 10.0 * uniform(random);
    }
  }
}

TEST(RobustFit, IsAccurateDespiteOutliers)
{
  for (const double part : {0.05, 0.1, 0.2})
  {
    Random random(1200);
    const RadialModel truth = test::RandomOrgan(random, 8);
    RadialSamples samples = test::SamplesOf(truth, 14); // 1,962 of them, 81 coefficients
    test::AddNoise(random, Noise, samples);
    AddOutliers(random, part, samples);
    Options options = Huber(8);
    const RadialModelFitResult robust = Fit(samples, options);
    options.RobustKind = Options::Robust::None;
    const RadialModelFitResult plain = Fit(samples, options);
    const double robustError = test::Distance(robust.Coefficients, truth.Coefficients());
    const double plainError = test::Distance(plain.Coefficients, truth.Coefficients());
    // Outliers on one side shift the centre of the rest by about part / (1 - part) times 1.345
    // deviations, that is 0.05 to 0.2 mm here; least squares shifts by their mean, 10 mm part.
    EXPECT_LE(robustError, std::sqrt(4.0 * M_PI) * Noise * (0.3 + 4.0 * part)) << part;
    EXPECT_GE(plainError, 4.0 * robustError) << part;
    EXPECT_NEAR(robust.NoiseDeviation, Noise, Noise * (0.05 + 2.5 * part)) << part;
    EXPECT_GT(plain.NoiseDeviation, 2.0 * Noise) << part;
  }
}

TEST(RobustFit, IdentifiesOutliers)
{
  Random random(1210);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 6), 10);
  test::AddNoise(random, Noise, samples);
  for (std::size_t i = 0; i < samples.Radii.size(); i += 50)
  {
    samples.Radii[i] -= 8.0;
  }
  const RadialModelFitResult fit = Fit(samples, Huber(6));
  ASSERT_EQ(fit.RobustFactors.size(), samples.Radii.size());
  std::size_t below = 0;
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    EXPECT_GT(fit.RobustFactors[i], 0.0);
    EXPECT_LE(fit.RobustFactors[i], 1.0);
    below += fit.RobustFactors[i] < 1.0 ? 1 : 0;
    if (i % 50 == 0)
    {
      EXPECT_LT(fit.RobustFactors[i], 0.1) << i; // 1.345 * 0.3 mm of 8
    }
    else
    {
      EXPECT_GT(fit.RobustFactors[i], 0.2) << i; // within four deviations or so
    }
  }
  EXPECT_EQ(fit.DownWeighted, below);
}

TEST(RobustFit, FactorsFollowFromResiduals)
{
  Random random(1220);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 4), 8);
  samples.Weights.assign(samples.Radii.size(), 2.0);
  test::AddNoise(random, Noise, samples);
  AddOutliers(random, 0.1, samples);
  const RadialModelFitResult fit = Fit(samples, Huber(4));
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    const double limit = HuberWeights::Tuning * fit.NoiseDeviation;
    // The last step moved the radius by a ten-thousandth of the noise, rms.
    EXPECT_NEAR(fit.RobustFactors[i], std::min(1.0, limit / std::abs(fit.Residuals[i])), 2e-3);
  }
}

TEST(RobustFit, LosesLittleEfficiencyWithoutOutliers)
{
  double robust = 0.0;
  double plain = 0.0;
  for (unsigned seed = 1230; seed < 1290; ++seed)
  {
    Random random(seed);
    const RadialModel truth = test::RandomOrgan(random, 6);
    RadialSamples samples = test::SamplesOf(truth, 8);
    test::AddNoise(random, Noise, samples);
    Options options = Huber(6);
    robust += std::pow(test::Distance(Fit(samples, options).Coefficients, truth.Coefficients()), 2);
    options.RobustKind = Options::Robust::None;
    plain += std::pow(test::Distance(Fit(samples, options).Coefficients, truth.Coefficients()), 2);
  }
  // Huber's 95 % for normal errors; 60 fits of 49 coefficients determine the ratio to about 2 %.
  EXPECT_NEAR(plain / robust, 0.95, 0.04);
}

TEST(RobustFit, DeviationsCoverSpreadDespiteOutliers)
{
  Random random(1300);
  const RadialModel truth = test::RandomOrgan(random, 4);
  RadialSamples exact = test::SamplesOf(truth, 6);
  exact.Weights.assign(exact.Radii.size(), 1.0);
  constexpr int Trials = 200;
  std::vector<double> sum(25, 0.0);
  std::vector<double> squares(25, 0.0);
  std::vector<double> predicted(25, 0.0);
  for (int trial = 0; trial < Trials; ++trial)
  {
    RadialSamples samples = exact;
    test::AddNoise(random, Noise, samples);
    AddOutliers(random, 0.05, samples);
    const RadialModelFitResult fit = Fit(samples, Huber(4));
    const Eigen::MatrixXd factor = fit.Covariance.Factor();
    for (std::size_t k = 0; k < 25; ++k)
    {
      sum[k] += fit.Coefficients[k] / Trials;
      squares[k] += fit.Coefficients[k] * fit.Coefficients[k] / Trials;
      predicted[k] += factor.row(static_cast<Eigen::Index>(k)).squaredNorm() / Trials;
    }
  }
  double spread = 0.0;
  for (std::size_t k = 0; k < 25; ++k)
  {
    spread += (squares[k] - sum[k] * sum[k]) / predicted[k] / 25.0;
  }
  // A mean of 25 variances of 200 fits is known to sqrt(2 / 5000) = 2 %; the asymptotic formula
  // holds to a few percent for 362 samples and 25 coefficients.
  EXPECT_NEAR(spread, 1.0, 0.15);
}

TEST(RobustFit, SupportsPenaltiesAndOrthogonalMethod)
{
  Random random(1310);
  const RadialModel truth = test::RandomOrgan(random, 6);
  RadialSamples samples = test::SamplesOf(truth, 8);
  test::AddNoise(random, Noise, samples);
  AddOutliers(random, 0.1, samples);
  for (const auto penalty : {Options::Penalty::None, Options::Penalty::Given,
                             Options::Penalty::GeneralisedCrossValidation})
  {
    Options options = Huber(6);
    options.PenaltyKind = penalty;
    options.Roughness = 1e-5;
    const RadialModelFitResult fast = test::FitBy<MomentSolver>(samples, options);
    const RadialModelFitResult slow = test::FitBy<OrthogonalSolver>(samples, options);
    EXPECT_LE(test::Distance(fast.Coefficients, truth.Coefficients()),
              std::sqrt(4.0 * M_PI) * Noise);
    // Both stop where a step moves the radius by 1e-4 of the noise; cross-validation within 1e-3.
    EXPECT_LE(test::Distance(fast.Coefficients, slow.Coefficients), 1e-3);
    EXPECT_TRUE(fast.RmsByDegree.empty());
  }
}

TEST(RobustFit, EndsForExactAndDegenerateSamples)
{
  Random random(1320);
  const RadialModel truth = test::RandomOrgan(random, 4);
  const RadialSamples exact = test::SamplesOf(truth, 6);
  const RadialModelFitResult fit = Fit(exact, Huber(4));
  EXPECT_LE(test::Distance(fit.Coefficients, truth.Coefficients()), 1e-10);
  // Exact but for one sample in five.
  RadialSamples some = exact;
  for (std::size_t i = 0; i < some.Radii.size(); i += 5)
  {
    some.Radii[i] += 10.0;
  }
  EXPECT_LE(test::Distance(Fit(some, Huber(4)).Coefficients, truth.Coefficients()), 0.5);
  // No centre at all: two clusters, and radii of 1e-150 and 1e100.
  RadialSamples two = exact;
  for (std::size_t i = 0; i < two.Radii.size(); i += 2)
  {
    two.Radii[i] = i % 4 == 0 ? 1e100 : 1e-150;
  }
  for (const double c : Fit(two, Huber(4)).Coefficients)
  {
    EXPECT_TRUE(std::isfinite(c));
  }
  RadialSamples zero = exact;
  zero.Radii.assign(zero.Radii.size(), 0.0);
  EXPECT_EQ(test::Norm(Fit(zero, Huber(4)).Coefficients), 0.0);
}

TEST(RobustFit, IgnoresZeroWeightSamples)
{
  Random random(1330);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 4), 8);
  test::AddNoise(random, Noise, samples);
  AddOutliers(random, 0.05, samples);
  const RadialSamples kept = test::SilenceEvery(4, samples);
  const RadialModelFitResult all = Fit(samples, Huber(4));
  const RadialModelFitResult some = Fit(kept, Huber(4));
  EXPECT_LE(test::Distance(all.Coefficients, some.Coefficients), 1e-10);
  EXPECT_EQ(all.DownWeighted, some.DownWeighted);
}

TEST(RobustFit, EndsWhenCancelled)
{
  Random random(1340);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 4), 6);
  test::AddNoise(random, Noise, samples);
  Options options = Huber(4);
  int asked = 0;
  options.IsCancelled = [&asked] { return asked++ >= 2; };
  RadialModelFitResult result;
  EXPECT_EQ(FitRadialModel(samples, options, result).Message(), "cancelled");
}
} // namespace
} // namespace palpate::robust_fit_test
