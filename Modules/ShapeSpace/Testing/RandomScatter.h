#pragma once

#include "RandomShapes.h"

#include <Eigen/Core>

namespace palpate::test
{
/// Independent standard normal numbers.
inline Eigen::MatrixXd NormalMatrix(Random& random, Eigen::Index rows, Eigen::Index columns)
{
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&]() { return normal(random); });
}

/// Cases (rows) around a mean that vary in `rank` directions, the k-th by 3 / (k + 1) mm.
inline Eigen::MatrixXd RandomCases(Random& random, Eigen::Index cases, Eigen::Index size,
                                   Eigen::Index rank)
{
  Eigen::MatrixXd scores = NormalMatrix(random, cases, rank);
  for (Eigen::Index k = 0; k < rank; ++k)
  {
    scores.col(k) *= 3.0 / static_cast<double>(k + 1);
  }
  const Eigen::RowVectorXd mean = 20.0 * NormalMatrix(random, 1, size);
  return (scores * NormalMatrix(random, rank, size)).rowwise() + mean;
}
} // namespace palpate::test
