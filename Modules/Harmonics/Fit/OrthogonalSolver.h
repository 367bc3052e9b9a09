#pragma once

#include "LeastSquaresSolver.h"

#include <Eigen/Core>
#include <limits>

namespace palpate
{
/// Least squares by a Householder factorisation of the matrix of all weighted samples: accurate at
/// every condition number, and the reference for the faster MomentSolver. Stores that matrix:
/// samples x coefficients x 24 bytes while it runs, 2 samples coefficients^2 operations.
class OrthogonalSolver : public LeastSquaresSolver
{
public:
  explicit OrthogonalSolver(int degree) : LeastSquaresSolver(degree) {}

  /// Always succeeds; the triangle may be singular.
  bool Reduce(const SampleView& samples) override;
  bool Solve(double strength) override;
  bool FactoriseSystem(double strength) override;
  bool Project() override { return true; }
  double HighestCondition() const noexcept override
  {
    return std::numeric_limits<double>::infinity();
  }

private:
  Eigen::MatrixXd Design;  // unweighted
  Eigen::MatrixXd Upper;   // R
  Eigen::VectorXd Rotated; // first entries of Q^T b, of the penalised system
};
} // namespace palpate
