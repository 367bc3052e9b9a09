#include "LeftOutProbability.h"

#include "LeftOutModes.h"
#include "ProbabilityDistributions.h"
#include "RandomShapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::left_out_probability_test
{
namespace
{
using palpate::test::Random;

std::vector<LeftOutDistance> DistancesIn(const Eigen::MatrixXd& cases)
{
  ShapeModes modes;
  EXPECT_TRUE(FindShapeModes(cases, modes).IsOk());
  const Eigen::Index count = CountDistanceModes(modes);
  LeftOutSolver solver(modes);
  std::vector<LeftOutDistance> distances;
  for (Eigen::Index row = 0; row < cases.rows(); ++row)
  {
    distances.push_back(DistanceFromOthers(solver.Solve(row), count, cases.rows()));
  }
  return distances;
}

// Standard deviations (mm) of the modes of 162 prostates, degree 12: measured for the first ten,
// and what falls as the others do.
double DeviationOfProstates(Eigen::Index mode)
{
  constexpr std::array<double, 10> First{12.94, 3.77, 2.95, 2.33, 2.08,
                                         1.71,  1.40, 1.35, 1.27, 1.15};
  return mode < 10 ? First[static_cast<std::size_t>(mode)]
                   : 1.1 * std::exp(-0.032 * static_cast<double>(mode - 10));
}

Eigen::MatrixXd NormalCases(Random& random, Eigen::Index cases, Eigen::Index modes)
{
  std::normal_distribution<double> normal;
  Eigen::MatrixXd scores =
      Eigen::MatrixXd::NullaryExpr(cases, modes, [&]() { return normal(random); });
  for (Eigen::Index k = 0; k < modes; ++k)
  {
    scores.col(k) *= DeviationOfProstates(k);
  }
  return scores;
}

/// How many cases of normal groups have p of at most a level, in %.
struct Rejected
{
  double At5 = 0.0;
  double At1 = 0.0;
  double Uncorrected = 0.0; ///< at 5 % by Hotelling's F as it is
};

Rejected RejectedIn(Eigen::Index cases, Eigen::Index modes, int groups)
{
  Random random(61);
  Rejected rejected;
  const double share = 100.0 / static_cast<double>(groups * cases);
  for (int group = 0; group < groups; ++group)
  {
    const std::vector<LeftOutDistance> distances = DistancesIn(NormalCases(random, cases, modes));
    const Eigen::VectorXd p = LeftOutProbabilities(distances);
    for (Eigen::Index i = 0; i < cases; ++i)
    {
      const LeftOutDistance& one = distances[static_cast<std::size_t>(i)];
      rejected.At5 += p[i] <= 0.05 ? share : 0.0;
      rejected.At1 += p[i] <= 0.01 ? share : 0.0;
      rejected.Uncorrected +=
          FisherUpper(one.F, one.NumeratorDegrees, one.DenominatorDegrees) <= 0.05 ? share : 0.0;
    }
  }
  return rejected;
}

struct GroupSize
{
  int Cases;
  int Groups;
};

class NormalGroups : public testing::TestWithParam<GroupSize>
{
};

// Bounds: 5 % and 1 % within what the factor's own error makes of them, plus three standard errors
// of 4,000 cases or more (0.35 and 0.16 %). Of ten cases, one mode and the limit on F leave few
// with a p below 1 %.
TEST_P(NormalGroups, HaveFewCasesThatLookUnusual)
{
  const GroupSize size = GetParam();
  const Rejected rejected = RejectedIn(size.Cases, 161, size.Groups);
  RecordProperty("at 5 %", std::to_string(rejected.At5));
  RecordProperty("at 1 %", std::to_string(rejected.At1));
  RecordProperty("uncorrected", std::to_string(rejected.Uncorrected));
  EXPECT_GE(rejected.At5, 3.5);
  EXPECT_LE(rejected.At5, 6.5);
  EXPECT_LE(rejected.At1, 1.5);
  EXPECT_LT(rejected.Uncorrected, rejected.At5);
}

INSTANTIATE_TEST_SUITE_P(Sizes, NormalGroups,
                         testing::Values(GroupSize{10, 600}, GroupSize{20, 300}, GroupSize{40, 150},
                                         GroupSize{160, 25}));

TEST(LeftOutProbabilities, OfModesThatDescribeEverythingAreHotellings)
{
  const Rejected rejected = RejectedIn(61, 3, 80);
  EXPECT_NEAR(rejected.Uncorrected, 5.0, 1.0); // three standard errors of 4,880 cases
  EXPECT_NEAR(rejected.At5, rejected.Uncorrected, 0.7);
}

LeftOutDistance DistanceWith(double f)
{
  LeftOutDistance distance;
  distance.F = f;
  distance.NumeratorDegrees = 2.0;
  distance.DenominatorDegrees = 32.0; // a mean of 32 / 30
  return distance;
}

TEST(LeftOutProbabilities, DivideByTheMeanOfLeftOutCasesOverFishers)
{
  const Eigen::VectorXd p = LeftOutProbabilities({DistanceWith(0.1), DistanceWith(0.9)});
  EXPECT_NEAR(p[1], FisherUpper(0.9 * (32.0 / 30.0) / 0.5, 2.0, 32.0), 1e-12);
}

// So cases that lie far away do not make each other less unusual than by Hotelling's F as it is.
TEST(LeftOutProbabilities, AreHotellingsWhereCasesAreFartherThanExpected)
{
  const Eigen::VectorXd p = LeftOutProbabilities({DistanceWith(0.5), DistanceWith(6.0)});
  EXPECT_DOUBLE_EQ(p[0], FisherUpper(0.5, 2.0, 32.0));
  EXPECT_DOUBLE_EQ(p[1], FisherUpper(6.0, 2.0, 32.0));
}

// 8.5 is the 99.9 % point.
TEST(LeftOutProbabilities, DoNotDependOnHowFarAnUnusualCaseLies)
{
  const auto with = [](double farthest)
  {
    std::vector<LeftOutDistance> distances(20, DistanceWith(0.2));
    distances.push_back(DistanceWith(farthest));
    return LeftOutProbabilities(distances)[0];
  };
  EXPECT_EQ(with(10.0), with(1000.0));
  EXPECT_NE(with(1.0), with(8.0));
}

TEST(LeftOutProbabilities, OneCaseFarAwayIsFoundInAGroupOfForty)
{
  Random random(63);
  Eigen::MatrixXd cases = NormalCases(random, 40, 161);
  cases(7, 2) = 8.0 * DeviationOfProstates(2);
  const Eigen::VectorXd p = LeftOutProbabilities(DistancesIn(cases));
  Eigen::Index least = 0;
  EXPECT_LT(p.minCoeff(&least), 1e-3);
  EXPECT_EQ(least, 7);
}

TEST(LeftOutProbabilities, AreOneWithoutDegreesOfFreedom)
{
  LeftOutDistance none;
  EXPECT_EQ(LeftOutProbabilities({none, none})[0], 1.0);
  EXPECT_EQ(LeftOutProbabilities({}).size(), 0);
}
} // namespace
} // namespace palpate::left_out_probability_test
