#pragma once

#include <Eigen/Core>

namespace palpate
{
/// Eigenvalues of a symmetric matrix in ascending order, and its orthonormal eigenvectors as
/// columns. Eigen's tridiagonal QR algorithm, which takes long to compile and is therefore compiled
/// once.
struct SymmetricEigen
{
  /// Of a matrix whose lower triangle is read; without `Vectors` unless `findsVectors`.
  explicit SymmetricEigen(const Eigen::MatrixXd& matrix, bool findsVectors = true);

  Eigen::VectorXd Values;
  Eigen::MatrixXd Vectors;
};
} // namespace palpate
