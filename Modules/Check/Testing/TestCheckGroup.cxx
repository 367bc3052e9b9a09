#include "CheckCases.h"
#include "CheckGroup.h"
#include "CheckRule.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace palpate::check_group_test
{
namespace
{
using namespace palpate::test;

// Cases of two organs drawn from one distribution, without voxels.
class CaseSource
{
public:
  explicit CaseSource(unsigned seed) : Random(seed) {}

  CheckedCase Draw()
  {
    CheckedCase patient;
    const Vector3 shift = 50.0 * this->Noise3();
    for (const double side : {1.0, -1.0})
    {
      CheckedOrgan organ;
      organ.Name = side > 0.0 ? "one" : "two";
      organ.Measured.Milliliters = 30.0 * std::exp(0.2 * this->Noise());
      organ.Measured.Centroid = shift + Vector3(20.0 * side, 0, 0) + 2.0 * this->Noise3();
      organ.Measured.Outline = this->Outline();
      organ.Measured.Outline.CenterWorld = organ.Measured.Centroid;
      organ.Measured.Statistics = {{"hole", 0.0, organ.Measured.Centroid, 0.0},
                                   {"neck", 0.1 + 0.05 * std::abs(this->Noise()), {0, 0, 0}, 0.0}};
      patient.Organs.push_back(organ);
    }
    return patient;
  }
  std::vector<CheckedCase> Draw(std::size_t count)
  {
    std::vector<CheckedCase> cases;
    std::generate_n(std::back_inserter(cases), count, [this] { return this->Draw(); });
    return cases;
  }

private:
  double Noise() { return this->Normal(this->Random); }
  Vector3 Noise3() { return {this->Noise(), this->Noise(), this->Noise()}; }
  RadialOutline Outline()
  {
    RadialOutline outline;
    outline.Coefficients = Eigen::VectorXd::Zero(169);
    outline.Coefficients[0] = 10.0 + 0.2 * this->Noise();
    for (int degree = 1; degree <= 12; ++degree)
    {
      for (int n = degree * degree; n < (degree + 1) * (degree + 1); ++n)
      {
        outline.Coefficients[n] = 0.1 / (degree * degree) * this->Noise();
      }
    }
    return outline;
  }

  std::mt19937 Random;
  std::normal_distribution<double> Normal;
};

// A dent of a heat kernel of 22 degrees in a direction.
void Dent(RadialOutline& outline, const Vector3& direction, double depth)
{
  const SphericalHarmonicBasis basis(12);
  Eigen::VectorXd values(169);
  basis.Evaluate(direction.normalized(), values.data());
  for (int degree = 0; degree <= 12; ++degree)
  {
    const double width = 22.0 / 180.0 * 3.14159265;
    for (int n = degree * degree; n < (degree + 1) * (degree + 1); ++n)
    {
      outline.Coefficients[n] -=
          depth * std::exp(-0.5 * degree * (degree + 1) * width * width) * values[n];
    }
  }
}

const CheckGroup& Group()
{
  static const CheckGroup group = CheckGroup::Of(CaseSource(1).Draw(99), 2);
  return group;
}

bool IsAlarm(const std::vector<OrganJudgement>& judged)
{
  return std::any_of(judged.begin(), judged.end(),
                     [](const OrganJudgement& one)
                     { return one.Is != OrganJudgement::Verdict::Plausible; });
}

TEST(CheckRules, BudgetsSumToOneAndKeysDiffer)
{
  double sum = 0.0;
  for (const CheckRule& rule : CheckRules())
  {
    sum += rule.Budget;
    EXPECT_EQ(FindCheckRule(rule.Key), &rule);
    EXPECT_LE(rule.Look, rule.Implausible);
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(FindCheckRule("end_left"), FindCheckRule("end"));
  EXPECT_EQ(FindCheckRule("endless"), nullptr);
}

TEST(CheckGroup, FalseAlarmsOfCasesAreAsRareAsAsked)
{
  CaseSource source(2);
  int alarms = 0;
  for (int n = 0; n < 400; ++n)
  {
    CheckedCase patient = source.Draw();
    alarms += IsAlarm(Group().Judge(patient, 0.1)) ? 1 : 0;
  }
  // Given the group the rate is Beta(10, 90): mean 0.1, deviation 0.03; with that of 400 draws,
  // four deviations are 0.13.
  EXPECT_GT(alarms, 4);
  EXPECT_LT(alarms, 92);
}

TEST(CheckGroup, ScoresAndProbabilitiesAreInverse)
{
  CheckGroup group;
  group.Scores = {1e-6, 1e-3, 0.01, 0.2, 3.0, 5.0, 8.0, 9.0, 10.0};
  EXPECT_DOUBLE_EQ(group.ProbabilityOf(1e-9), 0.1);
  EXPECT_DOUBLE_EQ(group.ProbabilityOf(1e-3), 0.2);
  EXPECT_DOUBLE_EQ(group.ScoreAt(0.3), 0.01);
  EXPECT_EQ(group.ScoreAt(0.05), 0.0);
  for (const double p : {0.11, 0.25, 0.4, 0.77})
  {
    EXPECT_NEAR(group.ProbabilityOf(group.ScoreAt(p)), p, 1e-12);
  }
}

TEST(CheckGroup, FindsHolesThatNoCleanCaseHas)
{
  CheckedCase patient = CaseSource(3).Draw();
  patient.Organs[1].Measured.Statistics.front() = {"hole", 0.05, {1, 2, 3}, 1500.0};
  const std::vector<OrganJudgement> judged = Group().Judge(patient, 0.05);
  EXPECT_EQ(judged[0].Is, OrganJudgement::Verdict::Plausible);
  EXPECT_EQ(judged[1].Is, OrganJudgement::Verdict::Implausible);
  EXPECT_EQ(judged[1].Reason.Key, "hole");
  EXPECT_EQ(judged[1].Reason.Place, Vector3(1, 2, 3));
  EXPECT_DOUBLE_EQ(judged[1].Probability, 0.01); // the least of 99 cases
}

TEST(CheckGroup, FindsDentsAndTheirPlaces)
{
  CheckedCase patient = CaseSource(4).Draw();
  RadialOutline& outline = patient.Organs[0].Measured.Outline;
  const Vector3 direction = Vector3(0.3, -0.8, 0.5).normalized();
  Dent(outline, direction, 0.5);
  const OrganJudgement judged = Group().Judge(patient, 0.05)[0];
  EXPECT_NE(judged.Is, OrganJudgement::Verdict::Plausible);
  const MaskStatistic shape = Find(patient.Organs[0].Measured.Statistics, "shape");
  EXPECT_LT(shape.Amount, 0.0);
  EXPECT_GT((shape.Place - outline.CenterWorld).normalized().dot(direction), 0.9);
}

TEST(CheckGroup, FindsOrgansThatExchangedTheirPlaces)
{
  CheckedCase patient = CaseSource(5).Draw();
  std::swap(patient.Organs[0].Measured.Centroid, patient.Organs[1].Measured.Centroid);
  for (const OrganJudgement& judged : Group().Judge(patient, 0.05))
  {
    EXPECT_EQ(judged.Is, OrganJudgement::Verdict::Implausible);
    EXPECT_EQ(judged.Reason.Key, "position");
  }
}

TEST(CheckGroup, DropsOddCasesButCalibratesWithThem)
{
  std::vector<CheckedCase> cases = CaseSource(6).Draw(60);
  Dent(cases[17].Organs[0].Measured.Outline, {0, 0, 1}, 3.0);
  const CheckGroup group = CheckGroup::Of(cases, 2);
  ASSERT_EQ(group.Dropped.size(), 1U);
  EXPECT_EQ(group.Dropped[0].Case, 17U);
  EXPECT_EQ(group.Dropped[0].Organ, "one");
  EXPECT_EQ(group.Find("one")->Cases, 59U);
  EXPECT_EQ(group.Find("two")->Cases, 60U);
  EXPECT_EQ(group.Scores.size(), 60U);
  EXPECT_LT(group.Scores[0], 0.01 * group.Scores[1]);
}

TEST(CheckGroup, CasesOfTheGroupAreJudgedWithoutThemselves)
{
  std::vector<CheckedCase> cases = CaseSource(11).Draw(40);
  cases[3].Organs[1].Measured.Statistics.front().Value = 0.05; // the only hole
  const CheckGroup group = CheckGroup::Of(cases, 2);
  EXPECT_LT(group.Scores[0], 1e-3 * group.Scores[1]);
}

TEST(CheckGroup, CasesCutByTheirImageDescribeNothing)
{
  std::vector<CheckedCase> cases = CaseSource(10).Draw(40);
  cases[3].Organs[1].Measured.Statistics.push_back({"border", 0.1, {1, 2, 3}, 200.0});
  const CheckGroup group = CheckGroup::Of(cases, 2);
  ASSERT_EQ(group.Dropped.size(), 1U);
  EXPECT_EQ(group.Dropped[0].Case, 3U);
  EXPECT_EQ(group.Dropped[0].Why.Key, "border");
  EXPECT_EQ(group.Scores.size(), 39U);
  const OrganJudgement judged = group.Judge(cases[3], 0.05)[1];
  EXPECT_EQ(judged.Is, OrganJudgement::Verdict::LookHere);
  EXPECT_EQ(judged.Reason.Key, "border");
}

TEST(CheckGroup, FewCasesMakeNone)
{
  EXPECT_TRUE(CheckGroup::Of(CaseSource(7).Draw(CheckGroup::LeastCases - 1), 1).Organs.empty());
  EXPECT_TRUE(CheckGroup::Of({}, 1).Organs.empty());
}

TEST(CheckGroup, OrgansThatItDoesNotHaveAreJudgedByLimits)
{
  CheckedCase patient = CaseSource(8).Draw();
  patient.Organs[0].Name = "three";
  patient.Organs[0].Measured.Statistics.front().Value = 0.05;
  const OrganJudgement judged = Group().Judge(patient, 0.05)[0];
  EXPECT_FALSE(judged.IsByGroup);
  EXPECT_EQ(judged.Is, OrganJudgement::Verdict::Implausible);
}

TEST(ShapeGroup, ReadsItsOwnMeanAndCovariance)
{
  const ShapeGroup& made = Group().Organs[0].Shape;
  const ShapeGroup read(made.Mean(), made.Covariance(), Group().Templates);
  const RadialOutline outline = CaseSource(9).Draw().Organs[0].Measured.Outline;
  const MaskStatistics one = made.Judge(outline, Group().Templates);
  const MaskStatistics other = read.Judge(outline, Group().Templates);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t n = 0; n < one.size(); ++n)
  {
    EXPECT_NEAR(one[n].Value, other[n].Value, 1e-6) << one[n].Key;
  }
}

const CheckRule SquareRule{"", 0.0, 0.0, 0.0, TailScale::Square, 0.5};
const CheckRule ShareRule{"", 0.0, 0.0, 0.0, TailScale::Logarithm, 0.2};

TEST(TailProbability, IsTheRankWithinAndFallsBeyond)
{
  std::vector<double> values(101);
  std::iota(values.begin(), values.end(), 0.0);
  const TailProbability tail(values, SquareRule);
  EXPECT_DOUBLE_EQ(tail.Of(50.0), 52.0 / 102.0);
  EXPECT_DOUBLE_EQ(tail.Of(-1.0), 1.0);
  EXPECT_DOUBLE_EQ(tail.Of(100.0), 2.0 / 102.0);
  EXPECT_DOUBLE_EQ(tail.Of(50.0, 50.0), 51.0 / 101.0);
  // The mean of (80 + n)^2 / 2 - 80^2 / 2 over n = 0..20 is 868.33.
  const double next = std::sqrt(100.0 * 100.0 + 2.0 * 868.333333);
  EXPECT_NEAR(tail.Of(next) / tail.Of(100.0 + 1e-9), std::exp(-1.0), 0.03); // 21 values, not 20.2
}

TEST(TailProbability, FewOddValuesDoNotHideWhatIsBeyondTheOthers)
{
  std::vector<double> values(100);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    values[n] = 0.003 * static_cast<double>(n);
  }
  values[99] = 0.9;
  const CheckRule bounded{"", 0.0, 0.0, 0.0, TailScale::Bounded, 0.05};
  EXPECT_LT(TailProbability(values, bounded).Of(0.7), 0.005);
  EXPECT_DOUBLE_EQ(TailProbability(values, SquareRule).Of(0.7), 2.0 / 101.0);
}

TEST(TailProbability, OneVoxelIsNotRareAmongMasksWithoutHoles)
{
  const TailProbability tail(std::vector<double>(50, 0.0), ShareRule);
  EXPECT_DOUBLE_EQ(tail.Of(0.0), 1.0);
  EXPECT_GT(tail.Of(1e-5), 0.9 / 51.0);
  EXPECT_LT(tail.Of(0.05), 1e-5);
}
} // namespace
} // namespace palpate::check_group_test
