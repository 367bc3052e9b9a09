#include "OrthogonalSolver.h"

#include "HouseholderReduction.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

bool OrthogonalSolver::Reduce(const SampleView& samples)
{
  this->Samples = samples;
  this->IsPenalised = false;
  const SphericalHarmonicBasis basis(this->MaximumDegree);
  const Index rows = samples.Count;
  const auto columns = static_cast<Index>(basis.Size());
  Matrix values(columns, rows);
  for (Index i = 0; i < rows; ++i)
  {
    basis.Evaluate(Eigen::Map<const Vector3>(samples.Directions + 3 * i), values.col(i).data());
  }
  this->Design = values.transpose();
  const Vector scales = Eigen::Map<const Vector>(samples.Weights, rows).cwiseSqrt();
  Matrix weighted = scales.asDiagonal() * this->Design;
  Vector rotated = scales.cwiseProduct(Eigen::Map<const Vector>(samples.Values, rows));
  householder::ReductionFor(FastestInstructionSet())(weighted.data(), rows, columns,
                                                     rotated.data());
  this->Upper = weighted.topRows(columns).triangularView<Eigen::Upper>();
  std::copy_n(rotated.begin(), columns, this->Projected.begin());
  this->UnreachableSquares = rotated.tail(rows - columns).squaredNorm();
  this->Reduced.SetFactor(this->Upper);
  return true;
}

// Factorises again with the penalty's rows below the triangle.
bool OrthogonalSolver::FactoriseSystem(double strength)
{
  this->IsPenalised = strength > 0.0;
  const Index size = this->Upper.cols();
  const Eigen::Map<const Vector> right(this->Projected.data(), size);
  if (!this->IsPenalised)
  {
    this->Rotated = right;
    return true;
  }
  Matrix stacked = Matrix::Zero(2 * size, size);
  stacked.topRows(size) = this->Upper;
  for (int l = 1; l <= this->MaximumDegree; ++l)
  {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i)
    {
      stacked(size + i, i) = std::sqrt(strength * Roughness(l));
    }
  }
  Vector stackedRight = Vector::Zero(2 * size);
  stackedRight.head(size) = right;
  householder::ReductionFor(FastestInstructionSet())(stacked.data(), 2 * size, size,
                                                     stackedRight.data());
  this->Rotated = stackedRight.head(size);
  this->Penalised = PackedTriangle(static_cast<int>(size));
  this->Penalised.SetFactor(stacked.topRows(size));
  return true;
}

bool OrthogonalSolver::Solve(double strength)
{
  this->FactoriseSystem(strength);
  std::copy(this->Rotated.begin(), this->Rotated.end(), this->Solution.begin());
  this->System().SolveUpper(this->Solution.data());
  const Eigen::Map<const Vector> coefficients(this->Solution.data(), this->Design.cols());
  const Vector residuals = Eigen::Map<const Vector>(this->Samples.Values, this->Samples.Count) -
                           this->Design * coefficients;
  this->Left.assign(residuals.begin(), residuals.end());
  return coefficients.allFinite();
}
} // namespace palpate
