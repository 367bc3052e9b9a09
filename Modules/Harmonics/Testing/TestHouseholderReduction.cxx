#include "HouseholderReduction.h"

#include "InstructionSets.h"

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <random>

namespace palpate::householder_reduction_test
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using test::NameOf;
using test::RunnableInstructionSets;

Matrix RandomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr(rows, columns, [&] { return normal(random); });
}

class HouseholderReduction : public testing::TestWithParam<InstructionSet>
{
};

// R^T R = A^T A and R x = Q^T b give the least-squares solution, whatever the signs of R's rows.
TEST_P(HouseholderReduction, KeepsGramMatrixAndSolution)
{
  const auto reduce = householder::ReductionFor(GetParam());
  for (const auto& [rows, columns] :
       {std::pair<int, int>{1, 1}, {7, 7}, {40, 9}, {300, 121}, {513, 169}})
  {
    const Matrix a = RandomMatrix(rows, columns, 7);
    const Vector b = RandomMatrix(rows, 1, 8);
    Matrix r = a;
    Vector rotated = b;
    reduce(r.data(), rows, columns, rotated.data());
    const Matrix upper = r.topRows(columns).triangularView<Eigen::Upper>();
    // Backward stable: some roundings for each of the rows.
    const double scale = rows * 1e-14 * a.squaredNorm();
    EXPECT_LE((upper.transpose() * upper - a.transpose() * a).norm(), scale);
    EXPECT_NEAR(rotated.norm(), b.norm(), rows * 1e-15 * b.norm());
    const Vector x = upper.triangularView<Eigen::Upper>().solve(rotated.head(columns));
    // The residual of the solution is orthogonal to every column.
    EXPECT_LE((a.transpose() * (a * x - b)).norm(),
              rows * 1e-14 * a.norm() * (a.norm() * x.norm() + b.norm()))
        << rows << " x " << columns;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, HouseholderReduction, testing::ValuesIn(RunnableInstructionSets()),
                         [](const auto& chosen) { return NameOf(chosen.param); });
} // namespace
} // namespace palpate::householder_reduction_test
