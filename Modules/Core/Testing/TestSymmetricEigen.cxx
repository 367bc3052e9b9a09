#include "SymmetricEigen.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace palpate
{
namespace
{
Eigen::MatrixXd RandomSymmetric(Eigen::Index size, std::uint64_t seed)
{
  test::Random random(seed);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd any =
      Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
  return any + any.transpose();
}
} // namespace

TEST(SymmetricEigenTest, GiveTheMatrixInAscendingOrder)
{
  for (const Eigen::Index size : {1, 2, 3, 7, 40})
  {
    const Eigen::MatrixXd matrix = RandomSymmetric(size, 5);
    const SymmetricEigen parts(matrix);
    const Eigen::MatrixXd product =
        parts.Vectors * parts.Values.asDiagonal() * parts.Vectors.transpose();
    EXPECT_LE((product - matrix).norm(), 1e-13 * matrix.norm()); // rounding
    EXPECT_TRUE(parts.Vectors.isUnitary(1e-12));
    EXPECT_TRUE(std::is_sorted(parts.Values.begin(), parts.Values.end()));
  }
}

TEST(SymmetricEigenTest, ValuesAloneAreTheSame)
{
  const Eigen::MatrixXd matrix = RandomSymmetric(20, 6);
  const SymmetricEigen alone(matrix, false);
  EXPECT_LE((alone.Values - SymmetricEigen(matrix).Values).norm(), 1e-13 * matrix.norm());
  EXPECT_EQ(alone.Vectors.size(), 0);
}

TEST(SymmetricEigenTest, OnlyTheLowerTriangleIsRead)
{
  const Eigen::MatrixXd matrix = RandomSymmetric(6, 7);
  const Eigen::MatrixXd lower = matrix.triangularView<Eigen::Lower>();
  EXPECT_EQ(SymmetricEigen(lower).Values, SymmetricEigen(matrix).Values);
}
} // namespace palpate
