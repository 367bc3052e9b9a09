#include "SurfaceCompletionCases.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace palpate::surface_posterior_test
{
namespace
{
using namespace palpate::test;

SurfaceRows RandomRows(Random& random, Eigen::Index size, Eigen::Index count)
{
  std::normal_distribution<double> normal;
  SurfaceRows rows;
  rows.Resize(size, count);
  for (Eigen::Index row = 0; row < count; ++row)
  {
    rows.Axes.col(row) = RandomDirection(random);
    rows.Moves[row] = row % 3 == 0 ? 0.0 : 1.0;
    for (Eigen::Index k = 0; k < size; ++k)
    {
      rows.Harmonics(k, row) = normal(random);
    }
  }
  return rows;
}

TEST(SurfacePosterior, IsTheClosedFormGaussianConditional)
{
  const auto prior = PlatePrior(1, false);
  ASSERT_NE(prior, nullptr);
  Random random(1);
  const Vector3 click(3.0, -4.0, 9.0);
  const SurfaceDistribution before = prior->About(click);
  const Eigen::MatrixXd dense = DenseCovariance(*prior, before.Covariance);
  const SurfaceRows rows = RandomRows(random, 49, 17);
  Eigen::MatrixXd noise = Eigen::MatrixXd::Identity(17, 17);
  noise(3, 4) = noise(4, 3) = 0.4;
  const Eigen::VectorXd values = 20.0 * Eigen::VectorXd::Random(17);
  SurfacePosterior posterior(prior, before);
  posterior.Condition(rows, values, noise);

  Eigen::VectorXd mean(before.Mean.size() + 3);
  mean << before.Mean, click;
  const Eigen::MatrixXd slopes = DenseRows(rows);
  const Eigen::MatrixXd gain =
      dense * slopes.transpose() * (slopes * dense * slopes.transpose() + noise).inverse();
  const Eigen::VectorXd expected = mean + gain * (values - slopes * mean);
  // Sums of 150 terms of up to 1,000 mm^2, and an inverse of condition 1e3.
  EXPECT_LT((posterior.Coefficients() - expected.head(before.Mean.size())).cwiseAbs().maxCoeff(),
            1e-8);
  EXPECT_LT((posterior.CentroidWorld() - expected.tail<3>()).norm(), 1e-8);
  const Eigen::MatrixXd left = dense - gain * slopes * dense;
  const SurfaceRows other = RandomRows(random, 49, 5);
  const Eigen::MatrixXd wanted = DenseRows(other) * left * DenseRows(other).transpose();
  EXPECT_LT((posterior.Covariance(other) - wanted).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((posterior.Variances(other) - wanted.diagonal()).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((posterior.After(other) - DenseRows(other) * expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(SurfacePosterior, WithoutObservationsIsThePrior)
{
  const auto prior = PlatePrior(2, false);
  Random random(2);
  const SurfaceDistribution before = prior->About(Vector3(1.0, 2.0, 3.0));
  const SurfacePosterior posterior(prior, before);
  const SurfaceRows rows = RandomRows(random, 49, 6);
  EXPECT_EQ(posterior.Coefficients(), prior->Mean);
  const Eigen::MatrixXd dense =
      DenseRows(rows) * DenseCovariance(*prior, before.Covariance) * DenseRows(rows).transpose();
  EXPECT_LT((posterior.Covariance(rows) - dense).cwiseAbs().maxCoeff(), 1e-8);
}
} // namespace
} // namespace palpate::surface_posterior_test
