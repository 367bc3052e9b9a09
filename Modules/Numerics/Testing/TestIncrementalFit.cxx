#include "IncrementalFit.h"

#include "FitSamples.h"
#include "SphericalHarmonicFit.h"

#include <gtest/gtest.h>
#include <numeric>

namespace palpate
{
namespace
{
using test::Random;
using Change = IncrementalFit::Change;

RadialSamples Samples(unsigned seed, int degree, int frequency)
{
  Random random(seed);
  RadialSamples samples = test::SamplesOf(test::RandomOrgan(random, degree), frequency);
  test::AddNoise(random, 0.3, samples);
  return samples;
}

std::vector<double> Fresh(const RadialSamples& samples, int degree, double strength)
{
  SphericalHarmonicFitOptions options;
  options.Degree = degree;
  options.PenaltyKind = strength > 0.0 ? SphericalHarmonicFitOptions::Penalty::Given
                                       : SphericalHarmonicFitOptions::Penalty::None;
  options.Roughness = strength;
  options.MaximumCondition = HUGE_VAL;
  SphericalHarmonicFitResult result;
  const Status status = FitSphericalHarmonics(samples, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result.Coefficients;
}

std::vector<double> CoefficientsOf(const IncrementalFit& fit)
{
  const auto size = static_cast<std::size_t>((fit.Degree() + 1) * (fit.Degree() + 1));
  return {fit.Coefficients(), fit.Coefficients() + size};
}

double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// The strength of a fresh fit of these samples whose minimum is that of the incremental one: a
// fresh fit scales its own weights.
double FreshStrength(const IncrementalFit& fit, const RadialSamples& samples, double strength)
{
  return strength * 4.0 * M_PI / (fit.Scale() * Sum(samples.Weights));
}

TEST(IncrementalFit, StartsAsAFreshFit)
{
  for (const double strength : {0.0, 1e-4})
  {
    const RadialSamples samples = Samples(1500, 8, 8);
    IncrementalFit fit(8);
    ASSERT_TRUE(fit.Start(samples, strength, 0).IsOk());
    EXPECT_EQ(fit.Count(), samples.Radii.size());
    EXPECT_LE(test::Distance(CoefficientsOf(fit), Fresh(samples, 8, strength)), 1e-11);
  }
}

TEST(IncrementalFit, AddedChangedAndRemovedSamplesGiveTheFreshFit)
{
  for (const double strength : {0.0, 1e-4})
  {
    Random random(1510);
    RadialSamples samples = Samples(1510, 6, 6);
    IncrementalFit fit(6);
    ASSERT_TRUE(fit.Start(samples, strength, 500).IsOk());
    for (const Vector3& direction : test::RandomDirections(random, 40))
    {
      std::size_t number = 0;
      ASSERT_EQ(fit.Add(direction, 25.0, 0.02, number), Change::Made);
      EXPECT_EQ(number, samples.Radii.size());
      samples.Directions.push_back(direction);
      samples.Radii.push_back(25.0);
      samples.Weights.push_back(0.02);
    }
    EXPECT_LE(test::Distance(CoefficientsOf(fit),
                             Fresh(samples, 6, FreshStrength(fit, samples, strength))),
              1e-11);
    for (std::size_t number = 3; number < samples.Radii.size(); number += 7)
    {
      samples.Radii[number] += 1.5;
      ASSERT_EQ(fit.SetRadius(number, samples.Radii[number]), Change::Made);
    }
    EXPECT_LE(test::Distance(CoefficientsOf(fit),
                             Fresh(samples, 6, FreshStrength(fit, samples, strength))),
              1e-11);
    for (std::size_t number = 5; number < samples.Radii.size(); number += 4)
    {
      ASSERT_EQ(fit.Remove(number), Change::Made);
      samples.Weights[number] = 0.0;
    }
    // Rounding of 70 mm at a condition of a few.
    EXPECT_LE(test::Distance(CoefficientsOf(fit),
                             Fresh(samples, 6, FreshStrength(fit, samples, strength))),
              1e-11);
  }
}

TEST(IncrementalFit, DriftsLittleOverAHundredThousandChanges)
{
  constexpr int Degree = 5;
  Random random(1520);
  RadialSamples samples = Samples(1520, Degree, 5); // 252
  IncrementalFit fit(Degree);
  ASSERT_TRUE(fit.Start(samples, 0.0, 0).IsOk());
  std::uniform_int_distribution<std::size_t> any(0, samples.Radii.size() - 1);
  std::normal_distribution<double> noise(0.0, 0.3);
  for (int step = 0; step < 50000; ++step)
  {
    // The oldest sample goes, another comes; and one gets a new radius.
    const std::size_t number = any(random);
    ASSERT_EQ(fit.Remove(number), Change::Made);
    const Vector3 direction = test::RandomDirection(random);
    std::size_t given = 0;
    samples.Directions[number] = direction;
    samples.Radii[number] = 20.0 + noise(random);
    ASSERT_EQ(fit.Add(direction, samples.Radii[number], samples.Weights[number], given),
              Change::Made);
    ASSERT_EQ(given, number);
  }
  const std::vector<double> fresh = Fresh(samples, Degree, 0.0);
  // 1e5 roundings of epsilon times a condition of some units, all on one side: 1e-10; in practice
  // they cancel to 1e-13.
  EXPECT_LE(test::Distance(CoefficientsOf(fit), fresh), 1e-10 * test::Norm(fresh));
  ASSERT_TRUE(fit.Restart().IsOk());
  EXPECT_LE(test::Distance(CoefficientsOf(fit), fresh), 1e-13 * test::Norm(fresh));
}

TEST(IncrementalFit, KeepsItsAccuracyOverManyRadiiAtDegree12)
{
  Random random(1530);
  RadialSamples samples = Samples(1530, 12, 8); // 642
  IncrementalFit fit(12);
  ASSERT_TRUE(fit.Start(samples, 0.0, 0).IsOk());
  std::uniform_int_distribution<std::size_t> any(0, samples.Radii.size() - 1);
  std::normal_distribution<double> noise(20.0, 1.0);
  for (int step = 0; step < 100000; ++step)
  {
    const std::size_t number = any(random);
    samples.Radii[number] = noise(random);
    ASSERT_EQ(fit.SetRadius(number, samples.Radii[number]), Change::Made);
  }
  const std::vector<double> fresh = Fresh(samples, 12, 0.0);
  EXPECT_LE(test::Distance(CoefficientsOf(fit), fresh), 1e-11 * test::Norm(fresh));
}

TEST(IncrementalFit, RefusesARemovalThatWouldLeaveItSingular)
{
  // As many samples as coefficients: none is spare.
  RadialSamples samples;
  samples.Directions = {{0, 0, 1}, {0, 0.6, -0.8}, {1, 0, 0}, {-0.8, -0.6, 0}};
  samples.Radii = {20, 21, 22, 23};
  samples.Weights = {1, 1, 1, 1};
  IncrementalFit fit(1);
  ASSERT_TRUE(fit.Start(samples, 0.0, 5).IsOk());
  const std::vector<double> before = CoefficientsOf(fit);
  for (std::size_t number = 0; number < 4; ++number)
  {
    EXPECT_EQ(fit.Remove(number), Change::Singular);
    EXPECT_FALSE(IncrementalFit::ToStatus(fit.Remove(number)).IsOk());
  }
  EXPECT_EQ(CoefficientsOf(fit), before);
  EXPECT_EQ(fit.Count(), 4U);
  // With one more, any one may go.
  std::size_t number = 0;
  ASSERT_EQ(fit.Add({0, 1, 0}, 24.0, 1.0, number), Change::Made);
  EXPECT_EQ(number, 4U);
  EXPECT_EQ(fit.Remove(2), Change::Made);
  EXPECT_EQ(fit.Remove(0), Change::Singular);
}

TEST(IncrementalFit, OfDegreeZeroIsTheWeightedMean)
{
  IncrementalFit fit(0);
  ASSERT_TRUE(fit.Start({{{0, 0, 1}}, {20.0}, {1.0}}, 0.0, 3).IsOk());
  EXPECT_EQ(fit.Remove(0), Change::Singular);
  std::size_t number = 0;
  ASSERT_EQ(fit.Add({1, 0, 0}, 26.0, 2.0, number), Change::Made);
  EXPECT_NEAR(fit.Coefficients()[0], 24.0 * std::sqrt(4 * M_PI), 1e-13); // rounding
  ASSERT_EQ(fit.SetRadius(0, 14.0), Change::Made);
  EXPECT_NEAR(fit.Coefficients()[0], 22.0 * std::sqrt(4 * M_PI), 1e-13);
  ASSERT_EQ(fit.Remove(0), Change::Made);
  EXPECT_NEAR(fit.Coefficients()[0], 26.0 * std::sqrt(4 * M_PI), 1e-13);
}

TEST(IncrementalFit, StaysAsItIsWhereItRefuses)
{
  const RadialSamples samples = Samples(1540, 4, 4);
  IncrementalFit fit(4);
  ASSERT_TRUE(fit.Start(samples, 0.0, samples.Radii.size() + 1).IsOk());
  const std::vector<double> before = CoefficientsOf(fit);
  const Vector3 up = Vector3::UnitZ();
  std::size_t number = 99;
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300})
  {
    EXPECT_EQ(fit.Add(up, bad, 1.0, number), Change::NotFinite);
    EXPECT_EQ(fit.Add(up, 20.0, bad, number), Change::NotFinite);
    EXPECT_EQ(fit.Add({0, bad, 1}, 20.0, 1.0, number), Change::NotFinite);
    EXPECT_EQ(fit.SetRadius(3, bad), Change::NotFinite);
  }
  EXPECT_EQ(fit.Add(up, 20.0, 0.0, number), Change::NotFinite);
  EXPECT_EQ(fit.Add(up, 20.0, -1.0, number), Change::NotFinite);
  EXPECT_EQ(fit.Add(2.0 * up, 20.0, 1.0, number), Change::NotFinite);
  EXPECT_EQ(fit.SetRadius(samples.Radii.size(), 20.0), Change::Unknown);
  EXPECT_EQ(fit.Remove(samples.Radii.size() + 7), Change::Unknown);
  EXPECT_EQ(number, 99U);
  EXPECT_EQ(CoefficientsOf(fit), before);
  EXPECT_EQ(fit.Count(), samples.Radii.size());
}

TEST(IncrementalFit, IsFullAtItsCapacityAndTakesNumbersAgain)
{
  const RadialSamples samples = Samples(1550, 4, 4);
  IncrementalFit fit(4);
  ASSERT_TRUE(fit.Start(samples, 0.0, samples.Radii.size()).IsOk());
  std::size_t number = 0;
  EXPECT_EQ(fit.Add({0, 0, 1}, 20.0, 1.0, number), Change::Full);
  ASSERT_EQ(fit.Remove(5), Change::Made);
  EXPECT_EQ(fit.Remove(5), Change::Unknown);
  EXPECT_EQ(fit.SetRadius(5, 20.0), Change::Unknown);
  EXPECT_EQ(fit.Add({0, 0, 1}, 20.0, 1.0, number), Change::Made);
  EXPECT_EQ(number, 5U);
}

TEST(IncrementalFit, RefusesToStartFromSamplesThatDetermineNothing)
{
  RadialSamples samples;
  samples.Directions.assign(30, Vector3(0.0, 0.0, 1.0));
  samples.Radii.assign(30, 5.0);
  samples.Weights.assign(30, 1.0);
  IncrementalFit fit(2);
  EXPECT_FALSE(fit.Start(samples, 0.0, 40).IsOk());
  EXPECT_FALSE(fit.Start({}, 0.0, 40).IsOk());
  EXPECT_FALSE(IncrementalFit(2).Restart().IsOk());
  EXPECT_FALSE(fit.Start(Samples(1560, 2, 3), -1.0, 40).IsOk());
  EXPECT_TRUE(fit.Start(Samples(1560, 2, 3), 1e-3, 40).IsOk());
}

TEST(IncrementalFit, EveryRefusalHasASentence)
{
  EXPECT_TRUE(IncrementalFit::ToStatus(Change::Made).IsOk());
  for (const Change change : {Change::NotFinite, Change::Full, Change::Unknown, Change::Singular})
  {
    EXPECT_FALSE(IncrementalFit::ToStatus(change).Message().empty());
  }
}
} // namespace
} // namespace palpate
