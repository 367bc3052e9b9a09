#include "PackedTriangle.h"

#include "TriangleKernelChoice.h"

#include <algorithm>
#include <limits>

namespace palpate
{
PackedTriangle::PackedTriangle(int size)
    : PackedTriangle(size, triangle::KernelFor(FastestInstructionSet()))
{
}

PackedTriangle::PackedTriangle(int size, const triangle::Kernel& kernel)
    : Rows(size), Strips((size + kernel.Lanes - 1) / kernel.Lanes), Arithmetic(&kernel)
{
  const auto lanes = static_cast<std::size_t>(kernel.Lanes);
  std::size_t start = 0;
  for (std::size_t strip = 0; strip < static_cast<std::size_t>(this->Strips); ++strip)
  {
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      this->RowStarts.push_back(start + lane);
    }
    start += lanes * lanes * (strip + 1);
  }
  this->Values.resize(start);
  this->Reciprocals.resize(this->RowStarts.size());
  this->Clear();
}

void PackedTriangle::Clear() noexcept
{
  std::fill(this->Values.begin(), this->Values.end(), 0.0);
  std::fill(this->Reciprocals.begin(), this->Reciprocals.end(), 1.0);
  for (int row = this->Rows; row < this->PaddedSize(); ++row)
  {
    this->At(row, row) = 1.0;
  }
}

bool PackedTriangle::Factorise() noexcept
{
  // Rounding error of a pivot that should be zero.
  const double smallest = 4.0 * this->Rows * std::numeric_limits<double>::epsilon();
  return this->Arithmetic->Factorise(this->Values.data(), this->Strips, smallest,
                                     this->Reciprocals.data());
}

void PackedTriangle::SetFactor(const Eigen::MatrixXd& upper)
{
  this->Clear();
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column <= row; ++column)
    {
      this->At(row, column) = upper(column, row);
    }
    this->Reciprocals[static_cast<std::size_t>(row)] = 1.0 / upper(row, row);
  }
}

Eigen::MatrixXd PackedTriangle::UpperFactor() const
{
  Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(this->Rows, this->Rows);
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column <= row; ++column)
    {
      upper(column, row) = this->At(row, column);
    }
  }
  return upper;
}

void PackedTriangle::SolveLower(double* x) const noexcept
{
  this->Arithmetic->SolveLower(this->Values.data(), this->Strips, this->Reciprocals.data(), x);
}

void PackedTriangle::SolveUpper(double* x) const noexcept
{
  this->Arithmetic->SolveUpper(this->Values.data(), this->Strips, this->Reciprocals.data(), x);
}

void PackedTriangle::Solve(double* x) const noexcept
{
  this->SolveLower(x);
  this->SolveUpper(x);
}

void PackedTriangle::MultiplyLower(const double* x, double* y) const noexcept
{
  this->Arithmetic->MultiplyLower(this->Values.data(), this->Strips, x, y);
}

void PackedTriangle::MultiplyUpper(const double* x, double* y) const noexcept
{
  this->Arithmetic->MultiplyUpper(this->Values.data(), this->Strips, x, y);
}
} // namespace palpate
