#pragma once

#include "HexElasticity.h"
#include "KernelProgress.h"
#include "Status.h"

#include <Eigen/Core>

#include <memory>

namespace palpate
{
/// Factors a symmetric positive definite matrix and solves with it, by MUMPS (Amestoy, Duff,
/// Koster, L'Excellent, SIAM J. Matrix Anal. Appl. 23, 2001) on the calling thread.
class SparseCholesky
{
public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Fails if memory is short, if the matrix is not positive definite in double precision, and if
  /// `progress` cancels. The numerical factorisation is one step, which cannot be interrupted.
  Status Factor(const StiffnessMatrix& lowerTriangle, const KernelProgress& progress);
  /// Replaces the columns, which are right sides, by the solutions. After Factor.
  Status Solve(Eigen::MatrixXd& columns);

private:
  struct Instance;
  std::unique_ptr<Instance> Solver;
};
} // namespace palpate
