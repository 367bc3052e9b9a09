#include "RadialModelFit.h"

#include "FitSamples.h"
#include "RadialModel.h"
#include "SphericalHarmonicBasis.h"
#include "ThinSvd.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace palpate::spherical_harmonic_fit_test
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

Options OfDegree(int degree)
{
  Options options;
  options.Degree = degree;
  return options;
}

// The error message if the fit was refused; empty otherwise.
std::string Refusal(const RadialSamples& samples, const Options& options)
{
  RadialModelFitResult result;
  return FitRadialModel(samples, options, result).Message();
}

Eigen::MatrixXd WeightedDesign(const RadialSamples& samples, int degree)
{
  const SphericalHarmonicBasis basis(degree);
  Eigen::MatrixXd design(static_cast<Eigen::Index>(samples.Radii.size()),
                         static_cast<Eigen::Index>(basis.Size()));
  std::vector<double> values(basis.Size());
  for (Eigen::Index i = 0; i < design.rows(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    basis.Evaluate(samples.Directions[at], values.data());
    design.row(i) = std::sqrt(samples.Weights[at]) *
                    Eigen::Map<Eigen::RowVectorXd>(values.data(), design.cols());
  }
  return design;
}

TEST(RadialModelFit, RecoversEveryModelUpToDegree24FromExactSamples)
{
  for (int degree = 0; degree <= 24; ++degree)
  {
    Random random(500U + static_cast<unsigned>(degree));
    const RadialModel model = test::RandomOrgan(random, degree);
    const RadialModelFitResult fit = Fit(test::SamplesOf(model, 10), OfDegree(degree));
    // The requirement; the rounding of samples alone would give about 1e-14 times the condition.
    EXPECT_LE(test::Distance(fit.Coefficients, model.Coefficients()),
              1e-10 * test::Norm(model.Coefficients()))
        << degree;
    EXPECT_LE(fit.Rms, 1e-11) << degree;
  }
}

TEST(RadialModelFit, RecoversModelOfDegree64FromExactSamples)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "minutes under a sanitizer; the lower degrees run the same code";
#endif
  Random random(564);
  const RadialModel model = test::RandomOrgan(random, 64);
  const RadialModelFitResult fit = Fit(test::SamplesOf(model, 22), OfDegree(64));
  EXPECT_LE(test::Distance(fit.Coefficients, model.Coefficients()),
            1e-10 * test::Norm(model.Coefficients())); // the requirement
}

TEST(RadialModelFit, ResidualsAreSampleMinusModelWithGivenRms)
{
  Random random(502);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 10), 8);
  const RadialModelFitResult fit = Fit(samples, OfDegree(5));
  const RadialModel model(5, fit.Coefficients, Vector3::Zero());
  double squares = 0.0;
  ASSERT_EQ(fit.Residuals.size(), samples.Radii.size());
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    // Radii of 20 mm, some roundings.
    EXPECT_NEAR(fit.Residuals[i], samples.Radii[i] - model.Radius(samples.Directions[i]), 1e-13);
    squares += samples.Weights[i] * fit.Residuals[i] * fit.Residuals[i];
  }
  const double total = std::accumulate(samples.Weights.begin(), samples.Weights.end(), 0.0);
  EXPECT_NEAR(fit.Rms / std::sqrt(squares / total), 1.0, 1e-12);
  EXPECT_GT(fit.Rms, 1e-3); // the truncated terms remain
}

TEST(RadialModelFit, ResidualsAreOrthogonalToBasis)
{
  Random random(503);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 6), 8);
  test::AddNoise(random, 0.5, samples);
  const RadialModelFitResult fit = Fit(samples, OfDegree(6));
  Eigen::VectorXd scaled(static_cast<Eigen::Index>(samples.Radii.size()));
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    scaled[static_cast<Eigen::Index>(i)] = std::sqrt(samples.Weights[i]) * fit.Residuals[i];
  }
  // The normal equations, which define the minimum: rounding of sums of total size 10.
  EXPECT_LE((WeightedDesign(samples, 6).transpose() * scaled).norm(), 1e-12);
}

TEST(RadialModelFit, OnlyRatiosOfWeightsMatter)
{
  Random random(504);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 6), 6);
  test::AddNoise(random, 0.5, samples);
  const RadialModelFitResult fit = Fit(samples, OfDegree(4));
  for (double& weight : samples.Weights)
  {
    weight *= 1234.5;
  }
  const RadialModelFitResult scaled = Fit(samples, OfDegree(4));
  EXPECT_LE(test::Distance(fit.Coefficients, scaled.Coefficients), 1e-12); // rounding of 70 mm
  EXPECT_NEAR(fit.NoiseDeviation, scaled.NoiseDeviation, 1e-13);
}

TEST(RadialModelFit, WeightTwoEqualsTwoSamples)
{
  Random random(505);
  RadialSamples once = test::SamplesOf(test::RandomOrgan(random, 6), 5);
  test::AddNoise(random, 0.5, once);
  once.Weights.assign(once.Radii.size(), 1.0);
  RadialSamples twice = once;
  for (std::size_t i = 0; i < once.Radii.size(); i += 3)
  {
    once.Weights[i] = 2.0;
    twice.Directions.push_back(twice.Directions[i]);
    twice.Radii.push_back(twice.Radii[i]);
    twice.Weights.push_back(1.0);
  }
  EXPECT_LE(
      test::Distance(Fit(once, OfDegree(4)).Coefficients, Fit(twice, OfDegree(4)).Coefficients),
      1e-12); // rounding of 70 mm
}

TEST(RadialModelFit, IgnoresZeroWeightSamples)
{
  Random random(506);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 6), 8);
  test::AddNoise(random, 0.5, samples);
  const RadialSamples kept = test::SilenceEvery(3, samples);
  for (const auto kind : {Options::Penalty::None, Options::Penalty::GeneralisedCrossValidation})
  {
    Options options = OfDegree(6);
    options.PenaltyKind = kind;
    const RadialModelFitResult all = Fit(samples, options);
    const RadialModelFitResult some = Fit(kept, options);
    // Rounding of 70 mm; the search for the strength ends within a thousandth on both sides.
    EXPECT_LE(test::Distance(all.Coefficients, some.Coefficients), 1e-11);
    EXPECT_NEAR(all.Rms / some.Rms, 1.0, 1e-11);
    EXPECT_NEAR(all.NoiseDeviation / some.NoiseDeviation, 1.0, 1e-11);
    EXPECT_NEAR(all.Condition / some.Condition, 1.0, 1e-5);
  }
}

TEST(RadialModelFit, RmsByDegreeMatchesRefits)
{
  Random random(507);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 14), 8);
  test::AddNoise(random, 0.1, samples);
  const RadialModelFitResult fit = Fit(samples, OfDegree(12));
  ASSERT_EQ(fit.RmsByDegree.size(), 13U);
  for (int l = 0; l <= 12; ++l)
  {
    const RadialModelFitResult refit = Fit(samples, OfDegree(l));
    EXPECT_NEAR(fit.RmsByDegree[static_cast<std::size_t>(l)] / refit.Rms, 1.0, 1e-11) << l;
  }
}

TEST(RadialModelFit, ConditionIsRatioOfSingularValues)
{
  Random random(508);
  const RadialSamples sphere = test::SamplesOf(test::RandomOrgan(random, 3), 10);
  for (const double cap : {0.0, 0.5, 0.8})
  {
    for (const int degree : {1, 5, 12})
    {
      const RadialSamples samples = test::WithoutCap(sphere, cap);
      Options options = OfDegree(degree);
      options.MaximumCondition = std::numeric_limits<double>::infinity();
      const Eigen::VectorXd values = ThinSvd(WeightedDesign(samples, degree)).Values;
      const double exact = values[0] / values[values.size() - 1];
      // The power iteration stops when a step changes it by 1e-6; near-equal singular values make
      // it stop early, but then they are near equal.
      EXPECT_NEAR(Fit(samples, options).Condition / exact, 1.0, 0.02) << cap << " " << degree;
    }
  }
}

TEST(RadialModelFit, RotatedSamplesHaveSamePowerSpectrum)
{
  Random random(509);
  const RadialModel model = test::RandomOrgan(random, 8);
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Vector3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  RadialSamples samples = test::SamplesOf(model, 8);
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    samples.Radii[i] = model.Radius(rotation.transpose() * samples.Directions[i]);
  }
  const RadialModel rotated(8, Fit(samples, OfDegree(8)).Coefficients, Vector3::Zero());
  const std::vector<double> before = model.PowerSpectrum();
  const std::vector<double> after = rotated.PowerSpectrum();
  for (std::size_t l = 0; l < before.size(); ++l)
  {
    EXPECT_NEAR(after[l], before[l], 1e-13 * before[0]); // rounding of the largest entry
  }
}

TEST(RadialModelFit, RejectsFewerSamplesThanCoefficients)
{
  Random random(510);
  const RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 3), 3); // 92 samples
  EXPECT_EQ(Refusal(samples, OfDegree(8)), "");                                   // 81
  const std::string message = Refusal(samples, OfDegree(9));                      // 100
  EXPECT_NE(message.find("92 samples"), std::string::npos) << message;
  EXPECT_NE(message.find("100 coefficients"), std::string::npos) << message;
}

TEST(RadialModelFit, RejectsFewerWeightedSamplesThanCoefficients)
{
  Random random(511);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 3), 3);
  std::fill(samples.Weights.begin(), samples.Weights.begin() + 12, 0.0);
  EXPECT_NE(Refusal(samples, OfDegree(8)).find("80 samples"), std::string::npos);
  samples.Weights.assign(samples.Radii.size(), 0.0);
  EXPECT_NE(Refusal(samples, OfDegree(0)).find("0 samples"), std::string::npos);
}

TEST(RadialModelFit, RejectsNonFiniteNumbers)
{
  Random random(512);
  const RadialSamples good = test::SamplesOf(test::RandomOrgan(random, 3), 4);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
  {
    RadialSamples samples = good;
    samples.Radii[7] = bad;
    EXPECT_NE(Refusal(samples, OfDegree(3)), "");
    samples = good;
    samples.Weights[7] = bad;
    EXPECT_NE(Refusal(samples, OfDegree(3)), "");
    samples = good;
    samples.Directions[7].y() = bad;
    EXPECT_NE(Refusal(samples, OfDegree(3)), "");
  }
}

TEST(RadialModelFit, RejectsInvalidWeightsDegreesAndCounts)
{
  Random random(513);
  const RadialSamples good = test::SamplesOf(test::RandomOrgan(random, 3), 4);
  RadialSamples samples = good;
  samples.Weights[3] = -1e-9;
  EXPECT_NE(Refusal(samples, OfDegree(3)).find("negative weight"), std::string::npos);
  samples = good;
  samples.Radii.pop_back();
  EXPECT_NE(Refusal(samples, OfDegree(3)), "");
  samples = good;
  samples.Weights.push_back(1.0);
  EXPECT_NE(Refusal(samples, OfDegree(3)), "");
  EXPECT_NE(Refusal(good, OfDegree(-1)), "");
  EXPECT_NE(Refusal({}, OfDegree(0)), "");
}

TEST(RadialModelFit, RejectsMissingCap)
{
  Random random(514);
  const RadialSamples samples =
      test::WithoutCap(test::SamplesOf(test::RandomOrgan(random, 3), 20), M_PI / 3);
  const std::string message = Refusal(samples, OfDegree(12));
  EXPECT_NE(message.find("condition"), std::string::npos) << message;
  EXPECT_NE(message.find("penalty"), std::string::npos) << message;
  Options penalised = OfDegree(12);
  penalised.PenaltyKind = Options::Penalty::Given;
  penalised.Roughness = 1e-6;
  EXPECT_EQ(Refusal(samples, penalised), "");
}

TEST(RadialModelFit, RejectsRepeatedDirection)
{
  RadialSamples samples;
  samples.Directions.assign(100, Vector3(0.0, 0.0, 1.0));
  samples.Radii.assign(100, 5.0);
  samples.Weights.assign(100, 1.0);
  EXPECT_NE(Refusal(samples, OfDegree(2)).find("condition"), std::string::npos);
}

TEST(RadialModelFit, FailsWhenCancelled)
{
  Random random(515);
  const RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, 3), 4);
  for (const auto kind : {Options::Penalty::None, Options::Penalty::GeneralisedCrossValidation})
  {
    for (int allowed = 0; allowed <= 1; ++allowed)
    {
      Options options = OfDegree(3);
      options.PenaltyKind = kind;
      int asked = 0;
      options.IsCancelled = [&asked, allowed] { return asked++ >= allowed; };
      const std::string message = Refusal(samples, options);
      EXPECT_EQ(message, asked > allowed ? "cancelled" : "");
      EXPECT_GT(asked, 0);
    }
  }
}
} // namespace
} // namespace palpate::spherical_harmonic_fit_test
