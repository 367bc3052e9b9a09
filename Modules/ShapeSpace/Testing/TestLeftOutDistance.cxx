#include "LeftOutDistance.h"

#include "RandomScatter.h"
#include "WorstCase.h"

#include <Eigen/Dense>

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::left_out_distance_test
{
namespace
{
using test::Random;
using test::WorstCase;

ShapeModes GroupModes(const Eigen::MatrixXd& cases)
{
  ShapeModes modes;
  EXPECT_TRUE(FindShapeModes(cases, modes).IsOk());
  return modes;
}

TEST(LeftOutDistance, IsThatOfTheOthersMeanAndCovariance)
{
  Random random(51);
  const Eigen::MatrixXd cases = test::RandomCases(random, 20, 4, 4);
  const ShapeModes modes = GroupModes(cases);
  LeftOutSolver solver(modes);
  WorstCase worst;
  for (Eigen::Index i = 0; i < cases.rows(); ++i)
  {
    Eigen::MatrixXd rest(19, 4);
    rest << cases.topRows(i), cases.bottomRows(19 - i);
    const Eigen::RowVectorXd mean = rest.colwise().mean();
    rest.rowwise() -= mean;
    const Eigen::VectorXd off = (cases.row(i) - mean).transpose();
    const double squared = off.dot((rest.transpose() * rest / 18.0).ldlt().solve(off));
    const LeftOutDistance distance = DistanceFromOthers(solver.Solve(i), 4, 20);
    worst.Add(distance.Mahalanobis / std::sqrt(squared) - 1.0);
    worst.Add(distance.F / (squared * 19.0 / 20.0 * 15.0 / (4.0 * 18.0)) - 1.0);
    worst.Add(distance.Outside);
  }
  EXPECT_LE(worst.Value(), 1e-10); // relative; rounding over the range of variances
}

// Of normal cases with all modes, F has Fisher's distribution; its mean with n degrees in the
// denominator is n / (n - 2).
TEST(LeftOutDistance, StatisticOfNormalCasesHasTheMeanOfFishersDistribution)
{
  Random random(52);
  constexpr int Trials = 4000;
  double sum = 0.0;
  double squares = 0.0;
  for (int trial = 0; trial < Trials; ++trial)
  {
    const ShapeModes modes = GroupModes(test::RandomCases(random, 30, 3, 3));
    const double f = DistanceFromOthers(LeftOutSolver(modes).Solve(0), 3, 30).F;
    sum += f;
    squares += f * f;
  }
  const double mean = sum / Trials;
  const double error = std::sqrt((squares / Trials - mean * mean) / Trials);
  EXPECT_NEAR(mean, 26.0 / 24.0, 4.0 * error);
}

TEST(LeftOutDistance, ModesThatAreNotUsedCountAsOutside)
{
  Random random(53);
  const ShapeModes modes = GroupModes(test::RandomCases(random, 12, 9, 9));
  const LeftOutModes others = LeftOutSolver(modes).Solve(2);
  const double all = others.Squares.sum() + others.Outside;
  const LeftOutDistance two = DistanceFromOthers(others, 2, 12);
  EXPECT_EQ(two.ModeCount, 2);
  EXPECT_NEAR(4.0 * M_PI * two.Outside * two.Outside, all - others.Squares.head(2).sum(),
              1e-12 * all);
}

TEST(LeftOutDistance, OfEqualOthersIsOnlyOutside)
{
  const ShapeModes modes = GroupModes((Eigen::MatrixXd(3, 1) << 2.0, 2.0, 5.0).finished());
  const LeftOutDistance distance = DistanceFromOthers(LeftOutSolver(modes).Solve(2), 1, 3);
  EXPECT_EQ(distance.ModeCount, 0);
  EXPECT_EQ(distance.F, 0.0);
  EXPECT_NEAR(distance.Outside, 3.0 / std::sqrt(4.0 * M_PI), 1e-12);
}

TEST(LeftOutDistance, UsesFewModesOfFewCasesAndThoseThatExplainEnough)
{
  Random random(54);
  EXPECT_EQ(CountDistanceModes(GroupModes(test::NormalMatrix(random, 51, 30))), 10);
  EXPECT_EQ(CountDistanceModes(GroupModes(test::NormalMatrix(random, 4, 9))), 1);
  Eigen::MatrixXd cases = test::NormalMatrix(random, 51, 30);
  cases.leftCols(2) *= 100.0;
  EXPECT_EQ(CountDistanceModes(GroupModes(cases)), 2);
  EXPECT_EQ(CountDistanceModes(GroupModes(Eigen::MatrixXd::Ones(5, 3))), 0);
}
} // namespace
} // namespace palpate::left_out_distance_test
