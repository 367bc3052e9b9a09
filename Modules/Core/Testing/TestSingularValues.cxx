#include "SingularValues.h"

#include "RandomOrientation.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate
{
namespace
{
constexpr double Rounding = 1e-14;

void ExpectDecomposed(const Matrix3& matrix)
{
  const SingularValues parts = SingularValuesOf(matrix);
  const Matrix3 product = parts.Left * parts.Values.asDiagonal() * parts.Right.transpose();
  EXPECT_LE((product - matrix).norm(), Rounding * matrix.norm());
  EXPECT_TRUE(parts.Left.isUnitary(Rounding));
  EXPECT_TRUE(parts.Right.isUnitary(Rounding));
  EXPECT_GE(parts.Values[0], parts.Values[1]);
  EXPECT_GE(parts.Values[1], parts.Values[2]);
  EXPECT_GE(parts.Values[2], 0.0);
}
} // namespace

TEST(SingularValuesTest, GiveTheMatrixFromTheLargest)
{
  test::Random random(31);
  for (int trial = 0; trial < 200; ++trial)
  {
    Matrix3 matrix;
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      matrix.col(i) = std::pow(10.0, trial % 7 - 3) * test::RandomDirection(random);
    }
    ExpectDecomposed(matrix);
  }
}

TEST(SingularValuesTest, MatricesOfAnyRankAreDecomposed)
{
  test::Random random(32);
  const Vector3 a = test::RandomDirection(random);
  const Vector3 b = test::RandomDirection(random);
  ExpectDecomposed(Matrix3::Zero());
  ExpectDecomposed(a * b.transpose());
  ExpectDecomposed(a * b.transpose() + b * a.transpose());
}

// Of a rotation, or a reflection, that is stretched along its axes.
TEST(SingularValuesTest, NearestOrthogonalMatrixIsTheOneThatWasStretched)
{
  test::Random random(33);
  for (int trial = 0; trial < 100; ++trial)
  {
    const double side = trial % 2 == 0 ? 1.0 : -1.0;
    const Matrix3 orthogonal = side * test::RandomOrientation(random);
    const Matrix3 axes = test::RandomOrientation(random);
    const Matrix3 stretch = axes * Vector3(3.0, 2.0, 0.5).asDiagonal() * axes.transpose();
    const Matrix3 nearest = SingularValuesOf(orthogonal * stretch).NearestOrthogonal();
    EXPECT_LE((nearest - orthogonal).norm(), 10.0 * Rounding); // 10: the condition number is 6
  }
}
} // namespace palpate
