#pragma once

#include <Eigen/Core>

namespace palpate
{
/// A part of a matrix, with products and solutions by BLAS on the calling thread (see
/// SingleBlasThread). Where one is symmetric or triangular its lower triangle is used.
class MatrixBlock
{
public:
  MatrixBlock(Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column, Eigen::Index rows,
              Eigen::Index columns) noexcept;

  /// Subtracts a b.
  void SubtractProduct(const MatrixBlock& a, const MatrixBlock& b);
  /// Subtracts a b'.
  void SubtractOuterProduct(const MatrixBlock& a, const MatrixBlock& b);
  /// Subtracts a a', of a symmetric matrix.
  void SubtractSquare(const MatrixBlock& a);
  /// Adds a' a, of a symmetric matrix.
  void AddProducts(const MatrixBlock& a);
  /// Becomes L^-1 of itself.
  void Solve(const MatrixBlock& lower);
  /// Becomes itself times L^-T.
  void SolveFromRight(const MatrixBlock& lower);

private:
  double* Data;
  int Rows;
  int Columns;
  int Stride;
};
} // namespace palpate
