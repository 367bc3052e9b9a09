#pragma once

#include "Status.h"
#include "SubjectRows.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
class SubjectWhitening;

/// What a mixed model finds in one outcome.
struct MixedFit
{
  double Criterion = 0.0; ///< -2 log restricted likelihood, with all constants
  Eigen::VectorXd Coefficients;
  Eigen::MatrixXd Covariance; ///< of the coefficients, with Kenward and Roger's correction
  double ResidualVariance = 0.0;
  Eigen::Matrix2d SubjectCovariance; ///< of intercept (at time 0) and slope; 0 without slopes
  /// A variance of 0 or a correlation of 1 or -1 in SubjectCovariance.
  bool IsSingular = false;
  /// False where the outcome has no variance, or none within subjects, beyond the fixed effects;
  /// the numbers above are NaN then.
  bool IsFound = false;

  ///@{ For tests: the covariance without correction, minus its derivative by each variance
  /// parameter, and the asymptotic covariance of these parameters.
  Eigen::MatrixXd PlainCovariance;
  std::vector<Eigen::MatrixXd> Decreases;
  Eigen::MatrixXd ParameterCovariance;
  ///@}
};

/// Test that several coefficients are 0.
struct FixedTest
{
  double F = 0.0; ///< scaled
  double NumeratorDegrees = 0.0;
  double DenominatorDegrees = 0.0;
  double P = 1.0;
};

/// A linear mixed model of repeated measurements: a random intercept and, if wanted, a random slope
/// of each subject, correlated with it, by restricted maximum likelihood (Patterson and Thompson,
/// Biometrika 58, 1971). The criterion is profiled over the Cholesky factor of the subjects'
/// covariance relative to the residual variance (Bates, Maechler, Bolker and Walker, J. Stat.
/// Softw. 67(1), 2015, eq. 39-42), with its exact gradient; its cost is linear in the subjects.
/// Tests are those of Kenward and Roger (Biometrics 53, 1997), which are exact for balanced groups.
class MixedModel
{
public:
  /// `fixed` has a row per measurement and full column rank, `subjects` a number from 0 on for each
  /// row, `times` a number per row or, without slopes, none. Fails if the variances cannot be
  /// separated: no subject has several measurements, or slopes have too few times.
  static Status Make(const Eigen::MatrixXd& fixed, const std::vector<Eigen::Index>& subjects,
                     const Eigen::VectorXd& times, MixedModel& model);

  /// One outcome per row. Safe from several threads.
  MixedFit Fit(const Eigen::VectorXd& outcome) const;

  /// Of the coefficients from `first` on; not a number where the fit is not found.
  static FixedTest Test(const MixedFit& fit, Eigen::Index first, Eigen::Index count);
  /// Half of the width of the confidence interval of a coefficient.
  static double ConfidenceWidth(const MixedFit& fit, Eigen::Index column, double confidence);

private:
  MixedFit Describe(const Eigen::Vector3d& factor, const SubjectOutcome& outcome) const;
  void AddCorrections(const SubjectWhitening& white, const Eigen::MatrixXd& inverse,
                      MixedFit& fit) const;

  SubjectRows Rows;
};
} // namespace palpate
