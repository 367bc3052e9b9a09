#include "PackedTriangle.h"

#include "ConditionEstimate.h"
#include "HouseholderReduction.h"
#include "InstructionSets.h"
#include "RandomShapes.h"
#include "TriangleKernelChoice.h"

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::packed_triangle_test
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using test::NameOf;
using test::RunnableInstructionSets;

constexpr int Sizes[] = {1, 2, 3, 4, 5, 7, 8, 13, 16, 31, 169};

Matrix RandomMatrix(int size, unsigned seed)
{
  test::Random random(seed);
  std::normal_distribution<double> normal;
  Matrix matrix(size, size);
  for (double& value : matrix.reshaped())
  {
    value = normal(random);
  }
  return matrix;
}

// Symmetric, with eigenvalues between one and a few hundred.
Matrix RandomSymmetric(int size)
{
  const Matrix square = RandomMatrix(size, static_cast<unsigned>(900 + size));
  return square * square.transpose() + Matrix::Identity(size, size);
}

// By Gram and Schmidt, twice for each column.
Matrix RandomOrthogonal(int size, unsigned seed)
{
  Matrix q = RandomMatrix(size, seed);
  for (int i = 0; i < size; ++i)
  {
    for (int pass = 0; pass < 2; ++pass)
    {
      q.col(i) -= q.leftCols(i) * (q.leftCols(i).transpose() * q.col(i)).eval();
      q.col(i) /= q.col(i).norm();
    }
  }
  return q;
}

PackedTriangle Pack(const Matrix& matrix, const triangle::Kernel& kernel)
{
  const int size = static_cast<int>(matrix.rows());
  PackedTriangle packed(size, kernel);
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      packed.At(i, j) = matrix(i, j);
    }
  }
  return packed;
}

CacheLineVector<double> Padded(const PackedTriangle& packed, const Vector& v)
{
  CacheLineVector<double> padded = packed.MakeVector();
  std::copy(v.begin(), v.end(), padded.begin());
  return padded;
}

// Distance to `expected`, relative; NaN and anything but zero in the padding count as infinite.
double Error(const CacheLineVector<double>& found, const Vector& expected)
{
  for (auto i = static_cast<std::size_t>(expected.size()); i < found.size(); ++i)
  {
    if (found[i] != 0.0)
    {
      return std::numeric_limits<double>::infinity();
    }
  }
  const double error =
      (Eigen::Map<const Vector>(found.data(), expected.size()) - expected).norm() / expected.norm();
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

TEST(PackedTriangle, FactorHasAPositiveDiagonalAndGivesTheMatrix)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const triangle::Kernel& kernel = triangle::KernelFor(set);
    for (const int size : Sizes)
    {
      const Matrix matrix = RandomSymmetric(size);
      PackedTriangle packed = Pack(matrix, kernel);
      ASSERT_TRUE(packed.Factorise()) << NameOf(set) << size;
      const Matrix upper = packed.UpperFactor();
      EXPECT_GT(upper.diagonal().minCoeff(), 0.0) << NameOf(set) << size;
      // Rounding of sums of `size` terms.
      EXPECT_LE((upper.transpose() * upper - matrix).norm(), 1e-13 * matrix.norm())
          << NameOf(set) << size;
    }
  }
}

TEST(PackedTriangle, SolvesAndMultiplies)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const triangle::Kernel& kernel = triangle::KernelFor(set);
    for (const int size : Sizes)
    {
      const Matrix matrix = RandomSymmetric(size);
      PackedTriangle packed = Pack(matrix, kernel);
      ASSERT_TRUE(packed.Factorise());
      const Matrix lower = packed.UpperFactor().transpose();
      const Vector x = RandomMatrix(size, 5).col(0);
      CacheLineVector<double> y = packed.MakeVector();
      packed.MultiplyLower(Padded(packed, x).data(), y.data());
      EXPECT_LE(Error(y, lower * x), 1e-12) << NameOf(set) << size;
      packed.SolveLower(y.data());
      EXPECT_LE(Error(y, x), 1e-11) << NameOf(set) << size;
      packed.MultiplyUpper(Padded(packed, x).data(), y.data());
      EXPECT_LE(Error(y, lower.transpose() * x), 1e-12) << NameOf(set) << size;
      packed.SolveUpper(y.data());
      EXPECT_LE(Error(y, x), 1e-11) << NameOf(set) << size;
      y = Padded(packed, matrix * x);
      packed.Solve(y.data());
      EXPECT_LE(Error(y, x), 1e-10) << NameOf(set) << size; // a condition of some hundreds
    }
  }
}

TEST(PackedTriangle, RejectsIndefiniteMatrix)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const triangle::Kernel& kernel = triangle::KernelFor(set);
    for (const int bad : {0, 1, 5, 8, 12})
    {
      Matrix matrix = RandomSymmetric(13);
      matrix(bad, bad) = -1.0;
      EXPECT_FALSE(Pack(matrix, kernel).Factorise()) << NameOf(set) << bad;
      matrix(bad, bad) = std::nan("");
      EXPECT_FALSE(Pack(matrix, kernel).Factorise()) << NameOf(set) << bad;
    }
    // Of rank 12, and so singular to rounding.
    const Matrix half = RandomMatrix(13, 7).leftCols(12);
    EXPECT_FALSE(Pack(half * half.transpose(), kernel).Factorise()) << NameOf(set);
    EXPECT_FALSE(Pack(Matrix::Zero(3, 3), kernel).Factorise()) << NameOf(set);
  }
}

TEST(PackedTriangle, SupportsNegativeDiagonal)
{
  const Matrix matrix = RandomSymmetric(13);
  PackedTriangle packed = Pack(matrix, triangle::KernelFor(RunnableInstructionSets().front()));
  ASSERT_TRUE(packed.Factorise());
  Matrix upper = packed.UpperFactor();
  upper.row(4) = -upper.row(4);
  packed.SetFactor(upper);
  EXPECT_EQ((packed.UpperFactor() - upper).norm(), 0.0);
  const Vector x = RandomMatrix(13, 8).col(0);
  CacheLineVector<double> y = Padded(packed, matrix * x);
  packed.Solve(y.data());
  EXPECT_LE(Error(y, x), 1e-11);
}

// Singular values fall evenly in their logarithm, or all but one are one.
TEST(ConditionEstimate, IsWithinFactorOfTwo)
{
  for (const int size : {1, 2, 9, 81, 169})
  {
    for (const double condition : {1.0, 2.0, 1e2, 1e4, 1e6})
    {
      for (const bool isolated : {false, true})
      {
        Vector values = Vector::Ones(size);
        for (int i = 0; i < size && !isolated && size > 1; ++i)
        {
          values[i] = std::pow(condition, -static_cast<double>(i) / (size - 1));
        }
        values[size - 1] = size > 1 ? 1.0 / condition : 1.0;
        Matrix matrix =
            RandomOrthogonal(size, 11) * values.asDiagonal() * RandomOrthogonal(size, 12);
        Vector right = Vector::Zero(size);
        householder::ReductionFor(RunnableInstructionSets().front())(matrix.data(), size, size,
                                                                     right.data());
        PackedTriangle packed(size);
        packed.SetFactor(matrix);
        const double ratio = EstimateCondition(packed) / (size > 1 ? condition : 1.0);
        // Never too large, but for the rounding of small singular values.
        EXPECT_LE(ratio, 1.0 + 1e-8) << size << " " << condition;
        EXPECT_GE(ratio, isolated ? 0.999 : 0.75) << size << " " << condition;
      }
    }
  }
}

TEST(ConditionEstimate, IsInfiniteForSingularAndNan)
{
  Matrix upper = RandomSymmetric(9);
  PackedTriangle packed(9);
  upper(3, 3) = 0.0;
  packed.SetFactor(upper);
  EXPECT_EQ(EstimateCondition(packed), std::numeric_limits<double>::infinity());
  upper(3, 3) = std::nan("");
  packed.SetFactor(upper);
  EXPECT_EQ(EstimateCondition(packed), std::numeric_limits<double>::infinity());
  upper(3, 3) = 1.0;
  upper(3, 7) = std::nan("");
  packed.SetFactor(upper);
  EXPECT_EQ(EstimateCondition(packed), std::numeric_limits<double>::infinity());
}
} // namespace
} // namespace palpate::packed_triangle_test
