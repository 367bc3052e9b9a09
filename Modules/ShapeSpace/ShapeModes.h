#pragma once

#include "Status.h"

#include <Eigen/Core>

namespace palpate
{
/// Variation of the shapes of a cohort: the principal components of their coefficients. As the
/// harmonics are orthonormal, these are those of the radii as functions on the sphere: a mode with
/// a score deviation d changes the radius by d / sqrt(4 pi) (mm, RMS over the directions).
struct ShapeModes
{
  Eigen::VectorXd Mean;       ///< coefficients, mm
  Eigen::MatrixXd Modes;      ///< one mode per column: coefficients of length 1
  Eigen::VectorXd Deviations; ///< standard deviation of each mode's scores (mm), descending
  Eigen::MatrixXd Scores;     ///< one case per row, one mode per column, mm; means are 0
  Eigen::VectorXd Explained;  ///< share of the total variance, 0..1, of each mode
};

/// `coefficients` has one case per row, all of one degree. Computed by singular values of the
/// centred matrix (variances over cases - 1); modes below rounding are omitted, at most cases - 1
/// remain. The sign of a mode is such that its largest entry is positive. Fails for fewer than two
/// cases and for non-finite numbers. Allocates.
Status FindShapeModes(const Eigen::MatrixXd& coefficients, ShapeModes& result);

/// The fewest first modes that explain 95 % of the variance, but a fifth of the free degrees at
/// most, since variances from few cases are too small, and one at least; 0 if there are no modes.
Eigen::Index CountStableModes(const ShapeModes& modes, Eigen::Index freeDegrees);
} // namespace palpate
