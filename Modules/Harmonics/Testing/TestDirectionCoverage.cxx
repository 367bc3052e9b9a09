#include "DirectionCoverage.h"

#include "FitSamples.h"
#include "MissingCaps.h"
#include "RadialModelFit.h"
#include "SphericalHarmonicBasis.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::direction_coverage_test
{
namespace
{
using test::Random;
using Verdict = DirectionCoverage::Verdict;

constexpr double Deg = M_PI / 180.0;

double Angle(const Vector3& a, const Vector3& b)
{
  return 2.0 * std::asin(std::min(1.0, 0.5 * (a - b).norm()));
}

std::vector<Vector3> WithoutCap(const std::vector<Vector3>& directions, const Vector3& center,
                                double angle)
{
  std::vector<Vector3> kept;
  for (const Vector3& direction : directions)
  {
    if (Angle(direction, center) > angle)
    {
      kept.push_back(direction);
    }
  }
  return kept;
}

RadialModelFitResult Fit(const RadialSamples& samples, int degree, double strength = 0.0)
{
  RadialModelFitOptions options;
  options.Degree = degree;
  options.PenaltyKind =
      strength > 0.0 ? RadialModelFitOptions::Penalty::Given : RadialModelFitOptions::Penalty::None;
  options.Roughness = strength;
  options.MaximumCondition = std::numeric_limits<double>::infinity();
  RadialModelFitResult fit;
  const Status status = FitRadialModel(samples, options, fit);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return fit;
}

RadialSamples UnitSamples(const std::vector<Vector3>& directions)
{
  const std::vector<double> ones(directions.size(), 1.0);
  return {directions, ones, ones};
}

DirectionCoverage Assess(const std::vector<Vector3>& directions, int degree, double strength = 0.0)
{
  const RadialSamples samples = UnitSamples(directions);
  DirectionCoverage coverage;
  const Status status =
      AssessCoverage(directions, samples.Weights, Fit(samples, degree, strength), coverage);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_FALSE(coverage.Message.empty());
  return coverage;
}

// Radius of the empty cap around a point.
double Distance(const std::vector<Vector3>& directions, const Vector3& point)
{
  double nearest = M_PI;
  for (const Vector3& direction : directions)
  {
    nearest = std::min(nearest, Angle(direction, point));
  }
  return nearest;
}

TEST(LargestEmptyCap, IsEmptyAndLargest)
{
  const IcosahedronDirections grid(40);
  for (unsigned seed = 1600; seed < 1606; ++seed)
  {
    Random random(seed);
    const std::vector<Vector3> directions =
        test::RandomDirections(random, seed == 1600 ? 3 : static_cast<int>(40 * (seed - 1599)));
    constexpr double Tolerance = 0.2 * Deg;
    const SphericalCap cap = LargestEmptyCap(directions, Tolerance);
    EXPECT_NEAR(cap.Center.norm(), 1.0, 1e-14);
    EXPECT_NEAR(Distance(directions, cap.Center), cap.Radius, 1e-12);
    for (const Vector3& point : grid.Directions())
    {
      EXPECT_LE(Distance(directions, point), cap.Radius + Tolerance + 1e-12);
    }
  }
}

TEST(LargestEmptyCap, MatchesKnownCapsOfFewDirections)
{
  EXPECT_EQ(LargestEmptyCap({}, 1e-2).Radius, M_PI);
  const SphericalCap one = LargestEmptyCap({Vector3(0, 0, 1)}, 1e-3);
  EXPECT_NEAR(one.Radius, M_PI, 1e-3); // the tolerance
  EXPECT_LE(Angle(one.Center, {0, 0, -1}), 1e-3);
  const SphericalCap two = LargestEmptyCap({Vector3(0, 0, 1), Vector3(0, 0, -1)}, 1e-3);
  EXPECT_NEAR(two.Radius, M_PI / 2, 1e-3);
  // Corners of an octahedron: the centre of a face.
  const SphericalCap six =
      LargestEmptyCap({{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}}, 1e-3);
  EXPECT_NEAR(six.Radius, std::acos(1.0 / std::sqrt(3.0)), 1e-3);
}

TEST(DirectionCoverage, FindsMissingCapsToDirectionSpacing)
{
  Random random(1610);
  const IcosahedronDirections sphere(20);
  const double spacing = std::sqrt(4.0 * M_PI / 4002.0);
  for (double cap = 10.0; cap <= 60.0; cap += 10.0)
  {
    const Vector3 center = test::RandomDirection(random);
    const DirectionCoverage found =
        Assess(WithoutCap(sphere.Directions(), center, cap * Deg), 12, 1e-3);
    EXPECT_NEAR(found.LargestGap.Radius, cap * Deg, spacing) << cap;
    EXPECT_LE(Angle(found.LargestGap.Center, center), spacing) << cap;
  }
}

TEST(DirectionCoverage, IgnoresZeroWeightDirections)
{
  const IcosahedronDirections sphere(12);
  std::vector<double> weights(sphere.Directions().size(), 1.0);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    weights[i] = sphere.Directions()[i].x() > std::cos(30.0 * Deg) ? 0.0 : 1.0;
  }
  RadialSamples samples = UnitSamples(sphere.Directions());
  samples.Weights = weights;
  DirectionCoverage coverage;
  ASSERT_TRUE(AssessCoverage(samples.Directions, weights, Fit(samples, 6), coverage).IsOk());
  EXPECT_NEAR(coverage.LargestGap.Radius, 30.0 * Deg, std::sqrt(4.0 * M_PI / 1442.0));
  EXPECT_LE(Angle(coverage.LargestGap.Center, {1, 0, 0}), std::sqrt(4.0 * M_PI / 1442.0));
}

TEST(DirectionCoverage, NoiseGainIsRelativeRadiusDeviation)
{
  Random random(1620);
  const RadialModel truth = test::RandomOrgan(random, 8);
  RadialSamples samples = test::WithoutCap(test::SamplesOf(truth, 10), 20.0 * Deg);
  samples.Weights.assign(samples.Radii.size(), 1.0);
  test::AddNoise(random, 0.3, samples);
  for (const double strength : {0.0, 1e-4})
  {
    const RadialModelFitResult fit = Fit(samples, 8, strength);
    const DirectionCoverage coverage = Assess(samples.Directions, 8, strength);
    const SphericalHarmonicBasis basis(8);
    std::vector<double> values(basis.Size());
    double largest = 0.0;
    double squares = 0.0;
    const IcosahedronDirections sphere(30);
    const std::vector<double> angles = sphere.SolidAngles();
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      basis.Evaluate(sphere.Directions()[i], values.data());
      const double gain = fit.Covariance.RadiusDeviation(values.data()) / fit.NoiseDeviation;
      largest = std::max(largest, gain);
      squares += angles[i] * gain * gain / (4.0 * M_PI);
    }
    // The search ends within a few thousandths of a radian of the maximum.
    EXPECT_NEAR(coverage.NoiseGainMaximum / largest, 1.0, 0.01) << strength;
    // The quadrature of the test.
    EXPECT_NEAR(coverage.NoiseGainRms / std::sqrt(squares), 1.0, 1e-3) << strength;
    EXPECT_NEAR(coverage.Condition / fit.Condition, 1.0, 1e-9) << strength;
    basis.Evaluate(coverage.NoiseGainDirection, values.data());
    EXPECT_NEAR(fit.Covariance.RadiusDeviation(values.data()) / fit.NoiseDeviation /
                    coverage.NoiseGainMaximum,
                1.0, 1e-9);
  }
}

TEST(DirectionCoverage, FullSphereIsGood)
{
  const DirectionCoverage coverage = Assess(IcosahedronDirections(20).Directions(), 12);
  EXPECT_EQ(coverage.Outcome, Verdict::Good) << coverage.Message;
  // 169 coefficients from 4,002 samples.
  EXPECT_NEAR(coverage.NoiseGainRms, std::sqrt(169.0 / 4002.0), 0.01);
  EXPECT_LE(coverage.LargestGap.Radius, 3.0 * Deg);
}

TEST(DirectionCoverage, TooFewDirectionsHaveTooMuchNoise)
{
  // 252 directions for 225 coefficients: no gap is wide, but the noise grows.
  const DirectionCoverage coverage = Assess(IcosahedronDirections(5).Directions(), 14);
  EXPECT_LT(coverage.LargestGap.Radius, DirectionCoverage::WidestGap(14));
  EXPECT_GT(coverage.NoiseGainMaximum, 1.0);
  EXPECT_NE(coverage.Outcome, Verdict::Good) << coverage.Message;
}

TEST(DirectionCoverage, MissingPartIsUndetermined)
{
  const std::vector<Vector3> directions =
      WithoutCap(IcosahedronDirections(20).Directions(), {0, 0, 1}, 70.0 * Deg);
  const DirectionCoverage coverage = Assess(directions, 12);
  EXPECT_EQ(coverage.Outcome, Verdict::Undetermined);
  EXPECT_FALSE(coverage.NoiseGainMaximum < 1e3);
  // A penalty determines the coefficients, but not the organ.
  EXPECT_EQ(Assess(directions, 12, 1e-3).Outcome, Verdict::Gaps);
  EXPECT_EQ(Assess(std::vector<Vector3>(50, Vector3(0, 0, 1)), 4, 1e-3).Outcome, Verdict::Gaps);
}

TEST(DirectionCoverage, RejectsWhatFitRejects)
{
  DirectionCoverage coverage;
  const std::vector<Vector3> directions = IcosahedronDirections(3).Directions();
  const std::vector<double> weights(directions.size(), 1.0);
  const RadialModelFitResult fit = Fit(UnitSamples(directions), 3);
  EXPECT_FALSE(AssessCoverage(directions, {}, fit, coverage).IsOk());
  EXPECT_FALSE(AssessCoverage({}, {}, fit, coverage).IsOk());
  const std::vector<Vector3> few(directions.begin(), directions.begin() + 15);
  EXPECT_FALSE(AssessCoverage(few, std::vector<double>(15, 1.0), fit, coverage).IsOk());
  std::vector<Vector3> bad = directions;
  bad[4].x() = std::nan("");
  EXPECT_FALSE(AssessCoverage(bad, weights, fit, coverage).IsOk());
}

class MissingCaps : public testing::Test
{
protected:
  static const std::vector<bench::MissingCapRow>& Rows()
  {
    static const std::vector<bench::MissingCapRow> rows = bench::MissingCaps(3);
    return rows;
  }
  static const bench::MissingCapRow& Row(double cap, const std::string& penalty)
  {
    for (const bench::MissingCapRow& row : Rows())
    {
      if (row.CapDegrees == cap && row.Penalty == penalty)
      {
        return row;
      }
    }
    static const bench::MissingCapRow none{};
    ADD_FAILURE() << "no row of " << cap << " degrees, " << penalty;
    return none;
  }
};

TEST_F(MissingCaps, PenaltiesHardlyIncreaseWorstError)
{
  for (int cap = 0; cap <= 60; cap += 10)
  {
    const bench::MissingCapRow& none = Row(cap, "none");
    for (const char* penalty : {"cross-validation", "1e-3"})
    {
      const bench::MissingCapRow& row = Row(cap, penalty);
      // The fixed strength smooths these bodies by up to 0.3 mm more than noise of 0.3 mm requires.
      EXPECT_LE(std::max(row.ErrorInside, row.ErrorOutside),
                std::max(none.ErrorInside, none.ErrorOutside) + 0.3)
          << cap << penalty;
      EXPECT_LE(row.NoiseGainMaximum, none.NoiseGainMaximum * 1.001) << cap << penalty;
    }
  }
}

TEST_F(MissingCaps, PenaltiesBoundErrorInside)
{
  for (int cap = 10; cap <= 60; cap += 10)
  {
    EXPECT_LE(Row(cap, "cross-validation").ErrorInside, 2.0) << cap;
    EXPECT_LE(Row(cap, "1e-3").ErrorInside, 2.0) << cap;
  }
  EXPECT_GE(Row(60, "none").ErrorInside, 100.0); // where no penalty helps
}

TEST_F(MissingCaps, VerdictWarnsWhereErrorsGrow)
{
  for (const bench::MissingCapRow& row : Rows())
  {
    // Without a cap or with one of 10 degrees the error inside is no worse than elsewhere.
    const bool grows = row.ErrorInside > 1.1 * Row(0, row.Penalty).ErrorOutside;
    EXPECT_TRUE(!grows || row.Verdict != Verdict::Good) << row.CapDegrees << row.Penalty;
    EXPECT_EQ(row.Verdict == Verdict::Good, row.CapDegrees < 15.0) << row.Message;
  }
  EXPECT_EQ(Row(60, "none").Verdict, Verdict::Undetermined);
}

TEST_F(MissingCaps, TableHasOneLinePerRow)
{
  const std::string table = bench::ToMarkdown(Rows());
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
            Rows().size() + 2);
}
} // namespace
} // namespace palpate::direction_coverage_test
