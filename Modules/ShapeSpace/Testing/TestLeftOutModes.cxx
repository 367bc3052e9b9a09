#include "LeftOutModes.h"

#include "RandomScatter.h"
#include "WorstCase.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::left_out_modes_test
{
namespace
{
using test::Random;
using test::WorstCase;

Eigen::MatrixXd Without(const Eigen::MatrixXd& cases, Eigen::Index leftOut)
{
  Eigen::MatrixXd rest(cases.rows() - 1, cases.cols());
  rest << cases.topRows(leftOut), cases.bottomRows(cases.rows() - 1 - leftOut);
  return rest;
}

/// The slow way: a decomposition of the other cases. The distance in `Outside` is all that no mode
/// describes.
LeftOutModes SlowLeftOut(const Eigen::MatrixXd& cases, Eigen::Index leftOut)
{
  ShapeModes others;
  EXPECT_TRUE(FindShapeModes(Without(cases, leftOut), others).IsOk());
  const Eigen::VectorXd from = cases.row(leftOut).transpose() - others.Mean;
  const Eigen::VectorXd scores = others.Modes.transpose() * from;
  return {others.Deviations.cwiseAbs2(), scores.cwiseAbs2(),
          (from - others.Modes * scores).squaredNorm()};
}

// Largest difference of deviations, scores and distance (mm) to the slow way, over all cases.
double LargestError(const Eigen::MatrixXd& cases)
{
  ShapeModes modes;
  EXPECT_TRUE(FindShapeModes(cases, modes).IsOk());
  LeftOutSolver solver(modes);
  WorstCase worst;
  for (Eigen::Index i = 0; i < cases.rows(); ++i)
  {
    const LeftOutModes fast = solver.Solve(i);
    const LeftOutModes slow = SlowLeftOut(cases, i);
    EXPECT_EQ(fast.Variances.size(), slow.Variances.size()) << i;
    if (fast.Variances.size() == slow.Variances.size())
    {
      for (Eigen::Index k = 0; k < fast.Variances.size(); ++k)
      {
        worst.Add(std::sqrt(fast.Variances[k]) - std::sqrt(slow.Variances[k]));
        worst.Add(std::sqrt(fast.Squares[k]) - std::sqrt(slow.Squares[k]));
      }
    }
    worst.Add(std::sqrt(fast.Outside) - std::sqrt(slow.Outside));
  }
  return worst.Value();
}

// mm. Rounding of numbers of some tens over the relative difference of two variances.
constexpr double Rounding = 1e-8;

TEST(LeftOutModes, AreThoseOfOtherCasesWithFewerModesThanCases)
{
  Random random(31);
  EXPECT_LE(LargestError(test::RandomCases(random, 40, 25, 12)), Rounding);
  EXPECT_LE(LargestError(test::RandomCases(random, 40, 25, 25)), Rounding);
  EXPECT_LE(LargestError(test::RandomCases(random, 9, 25, 1)), Rounding);
}

TEST(LeftOutModes, AreThoseOfOtherCasesWithAsManyModesAsPossible)
{
  Random random(32);
  EXPECT_LE(LargestError(test::RandomCases(random, 12, 49, 49)), Rounding);
  EXPECT_LE(LargestError(test::RandomCases(random, 4, 9, 9)), Rounding);
  EXPECT_LE(LargestError(test::RandomCases(random, 3, 9, 9)), Rounding);
}

TEST(LeftOutModes, CaseThatIsAloneInADirectionLeavesNoModeThere)
{
  Random random(33);
  Eigen::MatrixXd cases = test::RandomCases(random, 20, 16, 3);
  cases.col(15).setConstant(4.0);
  cases(7, 15) = 9.0;
  EXPECT_LE(LargestError(cases), Rounding);
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(cases, modes).IsOk());
  const LeftOutModes alone = LeftOutSolver(modes).Solve(7);
  EXPECT_EQ(alone.Variances.size(), 3);
  EXPECT_GT(alone.Outside, 1.0);
}

TEST(LeftOutModes, EqualVariancesAndScoresOfZeroAreKept)
{
  // Each mode has the same variance; each case has a score in one of them only.
  Eigen::MatrixXd cases = Eigen::MatrixXd::Zero(8, 5);
  for (Eigen::Index k = 0; k < 4; ++k)
  {
    cases(2 * k, k) = 3.0;
    cases(2 * k + 1, k) = -3.0;
  }
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(cases, modes).IsOk());
  const LeftOutModes others = LeftOutSolver(modes).Solve(0);
  // The others have scatter 18 in three directions; the mean moves by 3/7 in the fourth.
  ASSERT_EQ(others.Variances.size(), 4);
  EXPECT_NEAR(others.Variances[0], 18.0 / 6.0, 1e-12);
  EXPECT_NEAR(others.Variances[2], 18.0 / 6.0, 1e-12);
  EXPECT_NEAR(others.Variances[3], (18.0 - 8.0 / 7.0 * 9.0) / 6.0, 1e-12);
  EXPECT_NEAR(others.Squares.head(3).sum(), 0.0, 1e-12);
  EXPECT_NEAR(others.Squares[3], std::pow(3.0 * 8.0 / 7.0, 2), 1e-12);
}

TEST(LeftOutModes, TwoCasesLeaveNoMode)
{
  Random random(34);
  const Eigen::MatrixXd cases = test::RandomCases(random, 2, 9, 9);
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(cases, modes).IsOk());
  const LeftOutModes other = LeftOutSolver(modes).Solve(0);
  EXPECT_EQ(other.Variances.size(), 0);
  EXPECT_NEAR(std::sqrt(other.Outside), (cases.row(0) - cases.row(1)).norm(), 1e-11);
}

TEST(LeftOutModes, EqualCasesHaveNothingLeft)
{
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(Eigen::MatrixXd::Constant(5, 9, 2.0), modes).IsOk());
  const LeftOutModes others = LeftOutSolver(modes).Solve(3);
  EXPECT_EQ(others.Variances.size(), 0);
  EXPECT_EQ(others.Outside, 0.0);
}
} // namespace
} // namespace palpate::left_out_modes_test
