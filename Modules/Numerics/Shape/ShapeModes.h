#pragma once

#include "Status.h"

#include <Eigen/Core>

namespace palpate
{
/// How the shapes of a cohort vary: the principal components of their coefficients. As the
/// harmonics are orthonormal, these are those of the radii as functions on the sphere: a mode whose
/// scores deviate by d moves the radius by d / sqrt(4 pi) (mm, RMS over the directions).
struct ShapeModes
{
  Eigen::VectorXd Mean;       ///< coefficients, mm
  Eigen::MatrixXd Modes;      ///< a column a mode: coefficients of length 1
  Eigen::VectorXd Deviations; ///< standard deviation of each mode's scores (mm), falling
  Eigen::MatrixXd Scores;     ///< a row a case, a column a mode, mm; their means are 0
  Eigen::VectorXd Explained;  ///< the part of the whole variance, 0..1, of each mode
};

/// `coefficients` has a row a case, all of one degree. By singular values of the centred matrix
/// (variances over cases - 1); modes are as many as vary by more than rounding, at most cases - 1.
/// Of both signs a mode has that one whose largest entry is positive. Fails for fewer than two
/// cases and for numbers that are not finite. Allocates.
Status FindShapeModes(const Eigen::MatrixXd& coefficients, ShapeModes& result);
} // namespace palpate
