#pragma once

#include "CacheLineVector.h"
#include "TriangleKernel.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace palpate
{
/// The lower triangle of a square matrix: of a symmetric one, or of its Cholesky factor. Stored in
/// strips of a few rows (see triangle::Kernel), half the memory of the square, so that a matrix of
/// 169 rows fits the L2 cache.
///
/// Vectors handed to the members have PaddedSize() entries on a cache line
/// (CacheLineVector<double>); those past Size() are zero and stay so. Members that are const and
/// noexcept do not allocate.
class PackedTriangle
{
public:
  PackedTriangle() : PackedTriangle(0) {}
  explicit PackedTriangle(int size);
  PackedTriangle(int size, const triangle::Kernel& kernel);

  int Size() const noexcept { return this->Rows; }
  int PaddedSize() const noexcept { return this->Strips * this->Arithmetic->Lanes; }
  CacheLineVector<double> MakeVector() const
  {
    return CacheLineVector<double>(static_cast<std::size_t>(this->PaddedSize()), 0.0);
  }

  /// Index of entry (row, column), column <= row, in Data(): RowStart(row) + column * Lanes().
  std::size_t RowStart(int row) const noexcept
  {
    return this->RowStarts[static_cast<std::size_t>(row)];
  }
  int Lanes() const noexcept { return this->Arithmetic->Lanes; }
  double* Data() noexcept { return this->Values.data(); }
  double& At(int row, int column) noexcept { return this->Values[this->IndexOf(row, column)]; }
  double At(int row, int column) const noexcept { return this->Values[this->IndexOf(row, column)]; }

  /// Sets all entries to zero, and the diagonal past the last row to one.
  void Clear() noexcept;
  /// Replaces a symmetric positive definite matrix S by L with L L^T = S. Returns false, with
  /// undefined contents, if a pivot is below the rounding of its column or a number is not finite.
  bool Factorise() noexcept;
  /// Copies L = R^T from the upper triangle of `upper`, whose diagonal must have no zero.
  void SetFactor(const Eigen::MatrixXd& upper);
  /// R = L^T.
  Eigen::MatrixXd UpperFactor() const;

  ///@{ With the factor L: x := L^-1 x, x := L^-T x, x := (L L^T)^-1 x, y := L x, y := L^T x.
  void SolveLower(double* x) const noexcept;
  void SolveUpper(double* x) const noexcept;
  void Solve(double* x) const noexcept;
  void MultiplyLower(const double* x, double* y) const noexcept;
  void MultiplyUpper(const double* x, double* y) const noexcept;
  ///@}

private:
  std::size_t IndexOf(int row, int column) const noexcept
  {
    return this->RowStart(row) +
           static_cast<std::size_t>(column) * static_cast<std::size_t>(this->Arithmetic->Lanes);
  }

  int Rows;
  int Strips;
  const triangle::Kernel* Arithmetic;
  std::vector<std::size_t> RowStarts;
  CacheLineVector<double> Values;
  CacheLineVector<double> Reciprocals; // of the factor's diagonal
};
} // namespace palpate
