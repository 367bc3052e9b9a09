#pragma once

#include "LinearDesign.h"
#include "LinearOutcomes.h"

#include <Eigen/Core>

namespace palpate
{
/// Ordinary least squares of many outcomes on one design.
struct LinearModel
{
  Eigen::MatrixXd Coefficients;    ///< one row per column of the design, one column per outcome
  Eigen::MatrixXd StandardErrors;  ///< the same shape
  Eigen::VectorXd ResidualSquares; ///< sum over the cases, one per outcome
  Eigen::Index FreeDegrees = 0;    ///< cases - columns

  /// Half of the width of the confidence interval of each coefficient.
  Eigen::MatrixXd ConfidenceWidths(double confidence) const;
};

/// `outcomes` are those of the kept cases. Solved by an orthogonal basis of the design.
LinearModel FitLinearModel(const LinearDesign& design, const LinearOutcomes& outcomes);

/// Test of one term given all others, as R's drop1: F of each outcome.
struct TermTest
{
  Eigen::VectorXd F;
  Eigen::VectorXd P;
  Eigen::VectorXd PartialR2; ///< share of what the other terms leave that the term explains
};

/// Orthonormal bases of what a term adds to the others and of the others.
struct EffectSpace
{
  Eigen::MatrixXd Effect; ///< cases x columns of the term; a single one grows with the covariate
  Eigen::MatrixXd Others; ///< cases x other columns; the first is constant
};
EffectSpace FindEffectSpace(const LinearDesign& design, const DesignTerm& term);

TermTest TestTerm(const LinearDesign& design, const DesignTerm& term, const LinearModel& model,
                  const LinearOutcomes& outcomes);
} // namespace palpate
