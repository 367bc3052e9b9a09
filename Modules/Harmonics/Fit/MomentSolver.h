#pragma once

#include "GramAssembly.h"
#include "LeastSquaresSolver.h"
#include "MomentTables.h"
#include "ResidualMoments.h"
#include "SampleMoments.h"

#include <memory>

namespace palpate
{
/// Least squares by the normal equations, whose matrix is assembled from moments of the samples
/// (SampleMoments, GramAssembly) and factorised by Cholesky. The normal equations square the
/// condition number c of the problem, which iterative refinement compensates: residuals from the
/// samples, their moments, and a correction by the existing factor. Each step reduces the error by
/// about c^2 epsilon, down to that of an orthogonal factorisation. Fails if the condition is far
/// above HighestCondition() or the refinement does not converge.
/// An object keeps tables and memory for its degree, so that later fits do not allocate.
class MomentSolver : public LeastSquaresSolver
{
public:
  explicit MomentSolver(int degree);

  bool Reduce(const SampleView& samples) override;
  bool Solve(double strength) override;
  bool FactoriseSystem(double strength) override;
  bool Project() override { return this->Solve(0.0); }
  /// Up to here refinement reduces errors by about 1e-3 per step, and Cholesky factorisation
  /// succeeds.
  double HighestCondition() const noexcept override { return 1e6; }

private:
  MomentSolver(int degree, const moments::Kernel& kernel);
  bool Refine(double strength);
  double Correct(double strength);
  void ProjectSolution();

  std::shared_ptr<const MomentTables> Tables;
  SampleMoments Moments;
  ResidualMoments Residual;
  GramAssembly Assembly;
  PackedTriangle Gram;
  CacheLineVector<double> Right;
  CacheLineVector<double> Correction;
};
} // namespace palpate
