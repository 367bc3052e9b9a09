#pragma once

#include "PackedTriangle.h"
#include "SampleMoments.h"

#include <vector>

namespace palpate
{
/// Minimises sum_i w_i (r_i - R(u_i))^2 + strength sum_lm (l (l+1))^2 c_lm^2 over the coefficients
/// of a degree. The sample weights should sum to about 4 pi. MomentSolver forms the normal
/// equations from moments; OrthogonalSolver factorises the samples themselves.
class LeastSquaresSolver
{
public:
  virtual ~LeastSquaresSolver() = default;

  /// Factor of c_lm^2 in the penalty: (l (l+1))^2.
  static double Roughness(int degree) noexcept
  {
    const double l = degree;
    return l * l * (l + 1.0) * (l + 1.0);
  }

  /// Reduces the samples, which must outlive the calls of Solve, to Triangle(). Returns false if
  /// this solver cannot.
  virtual bool Reduce(const SampleView& samples) = 0;
  /// Computes Coefficients() and Residuals(). Returns false if this solver cannot do so accurately.
  /// With a strength of 0, Reduce must have found a Triangle() of full rank.
  virtual bool Solve(double strength) = 0;
  /// Computes System() for a strength without solving. Returns false as Solve does.
  virtual bool FactoriseSystem(double strength) = 0;

  /// Computes Projection() and Unreachable(). Returns false as Solve does.
  virtual bool Project() = 0;
  /// The largest condition number of the weighted samples for which this solver is accurate.
  virtual double HighestCondition() const noexcept = 0;

  /// L with L L^T = A^T A for the matrix A of weighted samples.
  const PackedTriangle& Triangle() const noexcept { return this->Reduced; }
  /// L with L L^T = A^T A + strength times the penalty, for the last strength.
  const PackedTriangle& System() const noexcept
  {
    return this->IsPenalised ? this->Penalised : this->Reduced;
  }
  /// (degree + 1)^2 coefficients, padded.
  const CacheLineVector<double>& Coefficients() const noexcept { return this->Solution; }
  /// Sample minus model, one per sample.
  const std::vector<double>& Residuals() const noexcept { return this->Left; }

  /// L^-1 A^T b, padded: coordinates of the weighted radii b in an orthonormal basis of the range
  /// of A. Its first (l + 1)^2 entries belong to degree l.
  const CacheLineVector<double>& Projection() const noexcept { return this->Projected; }
  /// Squared norm of the part of b outside the range of A: the residual of the unpenalised fit.
  double Unreachable() const noexcept { return this->UnreachableSquares; }

protected:
  explicit LeastSquaresSolver(int degree);
  LeastSquaresSolver(const LeastSquaresSolver&) = default;
  LeastSquaresSolver& operator=(const LeastSquaresSolver&) = default;

  int MaximumDegree;
  bool IsPenalised = false;
  SampleView Samples{};
  PackedTriangle Reduced;
  PackedTriangle Penalised;
  CacheLineVector<double> Solution;
  CacheLineVector<double> Projected;
  double UnreachableSquares = 0.0;
  std::vector<double> Left;
};
} // namespace palpate
