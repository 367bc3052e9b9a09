#pragma once

#include "SubjectRows.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// The rows of a mixed model after division by the Cholesky factors of their covariances, where
/// the subjects' effects have the covariance L L' in units of the residual variance, L the lower
/// triangle of `factor` (11, 21, 22).
class SubjectWhitening
{
public:
  SubjectWhitening(const SubjectRows& rows, const Eigen::Vector3d& factor);
  /// Leading rows to leading rows.
  Eigen::MatrixXd Whiten(const Eigen::MatrixXd& leading) const;

  Eigen::MatrixXd Fixed;
  Eigen::MatrixXd Effects;
  Eigen::LLT<Eigen::MatrixXd> Normal; ///< of the generalised least squares
  double LogDeterminant = 0.0;        ///< of the covariance and of Normal

  /// What the small-sample corrections need, for a residual variance of 1. The parameters are the
  /// residual variance and the subjects' variance or, with slopes, the entries 11, 21 and 22 of
  /// their covariance; V is the rows' covariance, V_i its derivative by one, X the fixed effects.
  struct Derivatives
  {
    std::vector<Eigen::MatrixXd> First;  ///< X' V^-1 V_i V^-1 X
    std::vector<Eigen::MatrixXd> Second; ///< X' V^-1 V_i V^-1 V_j V^-1 X, i times the count + j
    Eigen::MatrixXd Information;         ///< expected, of the restricted likelihood
  };
  Derivatives Differentiate(const SubjectRows& rows) const;

private:
  Eigen::ArrayXd L11;
  Eigen::ArrayXd L21;
  Eigen::ArrayXd L22;
};
} // namespace palpate
