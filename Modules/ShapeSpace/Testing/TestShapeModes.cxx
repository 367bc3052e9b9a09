#include "ShapeModes.h"

#include "RandomShapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::shape_modes_test
{
namespace
{
using test::Random;

Eigen::VectorXd RandomVector(Random& random, int degree)
{
  const std::vector<double> values = test::RandomCoefficients(random, degree, 1.0);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(ShapeModes, RecoversKnownMeanAndModes)
{
  Random random(11);
  const Eigen::VectorXd mean = 30.0 * RandomVector(random, 6);
  const Eigen::VectorXd first = RandomVector(random, 6).normalized();
  Eigen::VectorXd second = RandomVector(random, 6);
  second = (second - second.dot(first) * first).normalized();
  // Scores of mean 0 without correlation.
  const Eigen::Matrix<double, 4, 2> scores =
      (Eigen::Matrix<double, 4, 2>() << 3.0, 0.5, -3.0, 0.5, 3.0, -0.5, -3.0, -0.5).finished();
  Eigen::MatrixXd cases(4, mean.size());
  for (int row = 0; row < 4; ++row)
  {
    cases.row(row) = (mean + scores(row, 0) * first + scores(row, 1) * second).transpose();
  }
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(cases, modes).IsOk());
  // mm; rounding of numbers of some tens.
  EXPECT_LE((modes.Mean - mean).norm(), 1e-12);
  ASSERT_EQ(modes.Modes.cols(), 2);
  EXPECT_NEAR(std::abs(modes.Modes.col(0).dot(first)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(modes.Modes.col(1).dot(second)), 1.0, 1e-12);
  EXPECT_NEAR(modes.Deviations[0], std::sqrt(4 * 9.0 / 3.0), 1e-12);
  EXPECT_NEAR(modes.Deviations[1], std::sqrt(4 * 0.25 / 3.0), 1e-12);
  EXPECT_NEAR(modes.Explained[0], 9.0 / 9.25, 1e-12);
  EXPECT_NEAR(modes.Explained.sum(), 1.0, 1e-12);
  const double sign = modes.Modes.col(0).dot(first) > 0.0 ? 1.0 : -1.0;
  EXPECT_LE((modes.Scores.col(0) - sign * scores.col(0)).norm(), 1e-11);
}

TEST(ShapeModes, MeanAndScoresReproduceCases)
{
  Random random(12);
  Eigen::MatrixXd cases(9, 49);
  for (Eigen::Index row = 0; row < cases.rows(); ++row)
  {
    cases.row(row) = RandomVector(random, 6).transpose();
  }
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(cases, modes).IsOk());
  ASSERT_EQ(modes.Modes.cols(), 8);
  const Eigen::MatrixXd back =
      (modes.Scores * modes.Modes.transpose()).rowwise() + modes.Mean.transpose();
  EXPECT_LE((back - cases).norm(), 1e-12);
  for (Eigen::Index k = 0; k < modes.Modes.cols(); ++k)
  {
    EXPECT_GT(modes.Modes.col(k).maxCoeff(), -modes.Modes.col(k).minCoeff());
  }
}

TEST(ShapeModes, EqualCasesHaveNoModes)
{
  Random random(13);
  const Eigen::VectorXd one = 100.0 * RandomVector(random, 5);
  ShapeModes modes;
  ASSERT_TRUE(FindShapeModes(one.transpose().replicate(7, 1), modes).IsOk());
  EXPECT_EQ(modes.Modes.cols(), 0);
}

TEST(ShapeModes, RejectsTooFewOrNonFiniteCases)
{
  ShapeModes modes;
  EXPECT_FALSE(FindShapeModes(Eigen::MatrixXd::Ones(1, 4), modes).IsOk());
  Eigen::MatrixXd broken = Eigen::MatrixXd::Ones(3, 4);
  broken(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(FindShapeModes(broken, modes).IsOk());
}
} // namespace
} // namespace palpate::shape_modes_test
