#pragma once

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// An outcome as SubjectRows takes it: without what the fixed effects explain by least squares, of
/// length 1.
struct SubjectOutcome
{
  Eigen::VectorXd Leading;
  Eigen::VectorXd Reduced;   ///< of the other rows, in the space of the fixed effects
  double RestSquares = 0.0;  ///< of the other rows, beyond that space
  double Length = 0.0;       ///< before scaling
  Eigen::VectorXd Explained; ///< coefficients of the orthonormal fixed effects, before scaling
};

/// The rows of a mixed model, rotated within each subject such that its random effects (intercept
/// and slope) appear in two leading rows alone. All other rows have independent residuals and are
/// reduced once by a QR decomposition.
class SubjectRows
{
public:
  SubjectRows() = default;
  /// See MixedModel::Make. Each subject has a row.
  SubjectRows(const Eigen::MatrixXd& fixed, const std::vector<Eigen::Index>& subjects,
              const Eigen::VectorXd& times);
  SubjectOutcome Outcome(const Eigen::VectorXd& values) const;

  Eigen::Index Count = 0; ///< measurements
  Eigen::Index SubjectCount = 0;
  bool HasSlopes = false;
  ///@{ Leading rows: the first of each subject, then the second of each (0 if it has none).
  Eigen::MatrixXd Fixed;   ///< orthonormal combinations of the fixed effects
  Eigen::MatrixXd Effects; ///< of a subject's intercept and of its slope per standardised time
  ///@}
  Eigen::MatrixXd Reduced;  ///< the fixed effects of the other rows, as those of an outcome
  Eigen::MatrixXd Triangle; ///< fixed effects = orthonormal ones times it
  double MeanTime = 0.0;
  double TimeDeviation = 1.0;

private:
  struct Parts
  {
    Eigen::MatrixXd Leading;
    Eigen::MatrixXd Others;
  };
  Parts Rotate(const Eigen::MatrixXd& columns) const;

  std::vector<std::vector<Eigen::Index>> Members; ///< rows of each subject
  Eigen::MatrixXd Design;                         ///< of intercepts and slopes
  Eigen::MatrixXd Orthonormal;                    ///< fixed effects
  Eigen::MatrixXd Basis;                          ///< of the other rows
};
} // namespace palpate
