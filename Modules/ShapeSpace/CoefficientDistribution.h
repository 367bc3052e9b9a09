#pragma once

#include <Eigen/Core>

namespace palpate
{
/// The normal distribution of the coefficients of a function on the sphere over a group. With S the
/// covariance of the cases, mirrored copies among them if the mean is almost symmetric, and D the
/// diagonal of its mean variance for each degree, the covariance is 0.6 S + 0.4 D (shrinkage as
/// Ledoit and Wolf, J. Multivariate Analysis 88, 2004, with a fixed share: the one of largest
/// left-out likelihood for 163 prostates is 0.4, and flat around it).
struct CoefficientDistribution
{
  CoefficientDistribution() = default;
  /// Of cases, a row each of (L + 1)^2 coefficients (SphericalHarmonicBasis); at least two.
  explicit CoefficientDistribution(const Eigen::MatrixXd& cases);

  Eigen::VectorXd Mean;
  Eigen::MatrixXd Covariance; ///< positive definite
  bool IsMirrored = false;    ///< whether the cases' mirror images at x = 0 count as cases
};
} // namespace palpate
