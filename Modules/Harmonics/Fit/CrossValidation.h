#pragma once

#include "LeastSquaresSolver.h"

#include <Eigen/Core>

namespace palpate
{
/// Generalised cross-validation (Golub, Heath and Wahba, Technometrics 21, 1979) of the roughness
/// penalty, from the reduced problem of a solver that has its Projection(). The problem is
/// transformed to standard form (Hansen, Rank-Deficient and Discrete Ill-Posed Problems,
/// 1998, 2.3), where the singular values give the function for every strength. The constant term is
/// not penalised; it is projected out.
class CrossValidation
{
public:
  /// `samples`: number of samples with a weight. The solver's degree must be at least 1.
  CrossValidation(const LeastSquaresSolver& solver, double samples);

  /// The strength that minimises samples ||residual||^2 / (samples - trace)^2, to a thousandth, by
  /// golden-section search after a scan of twelve decades, since there may be several minima.
  double Strength() const;

private:
  double Function(double logStrength) const;
  double GoldenSection(double low, double high) const;

  double Samples;
  double Unreachable;
  Eigen::VectorXd Values; // singular values
  Eigen::VectorXd Right;
};
} // namespace palpate
