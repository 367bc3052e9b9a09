#include "DescriptionLength.h"

#include "RandomShapes.h"

#include <Eigen/LU>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::description_length_test
{
namespace
{
constexpr double Noise = 0.3; // mm^2

Eigen::MatrixXd RandomColumns(unsigned seed)
{
  test::Random random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(40, 6, [&] { return normal(random); });
}

// The determinant needs no eigenvalues: det(I + C^T C / ((n - 1) noise)) for centred C.
TEST(DescriptionLength, IsTheLogarithmOfADeterminant)
{
  const Eigen::MatrixXd shapes = RandomColumns(1);
  const Eigen::VectorXd mean = shapes.rowwise().mean();
  const Eigen::MatrixXd centred = shapes.colwise() - mean;
  const Eigen::MatrixXd products = centred.transpose() * centred / 5.0;
  const Eigen::MatrixXd whole = Eigen::MatrixXd::Identity(6, 6) + products / Noise;
  const DescriptionLength length = MeasureDescriptionLength(shapes, Noise, true);
  EXPECT_NEAR(length.Value, std::log(whole.determinant()), 1e-11);
  EXPECT_NEAR(length.Variance, products.trace(), 1e-11);
}

TEST(DescriptionLength, IsZeroForEqualShapesAndIgnoresACommonShift)
{
  const Eigen::MatrixXd shapes = RandomColumns(2);
  const Eigen::VectorXd shift = RandomColumns(3).col(0);
  EXPECT_NEAR(MeasureDescriptionLength(shift.replicate(1, 6), Noise, false).Value, 0.0, 1e-12);
  EXPECT_NEAR(MeasureDescriptionLength(shapes.colwise() + shift, Noise, false).Value,
              MeasureDescriptionLength(shapes, Noise, false).Value, 1e-11);
}

// Central differences lose the square of the step, and rounding over the step: some 1e-8.
TEST(DescriptionLength, PullIsTheDerivative)
{
  const Eigen::MatrixXd shapes = RandomColumns(4);
  const DescriptionLength length = MeasureDescriptionLength(shapes, Noise, true);
  const Eigen::MatrixXd slope = 2.0 / 5.0 * shapes * length.Pull;
  constexpr double Step = 1e-5;
  for (Eigen::Index row = 0; row < shapes.rows(); row += 7)
  {
    for (Eigen::Index column = 0; column < shapes.cols(); ++column)
    {
      Eigen::MatrixXd moved = shapes;
      moved(row, column) += Step;
      const double above = MeasureDescriptionLength(moved, Noise, false).Value;
      moved(row, column) -= 2.0 * Step;
      const double below = MeasureDescriptionLength(moved, Noise, false).Value;
      EXPECT_NEAR((above - below) / (2.0 * Step), slope(row, column), 1e-7);
    }
  }
}
} // namespace
} // namespace palpate::description_length_test
