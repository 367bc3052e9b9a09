#pragma once

#include "OrganModel.h"
#include "Status.h"
#include "TouchEquations.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// What another organ of the same patient, whose surface is known, says of one that is not: their
/// regression, and how far apart their surfaces lie. Lengths mm, patient LPS.
struct OrganRelation
{
  /// Degree to which the known organ's ln(radius / mm) counts in the regression.
  static constexpr int Degree = 4;
  static constexpr Eigen::Index ScoreCount = (Degree + 1) * (Degree + 1);
  static constexpr int WallFrequency = 3; ///< of the parameters whose distances are known: 92
  static constexpr Eigen::Index WallCount = 92;
  static constexpr double Ridge = 0.1; ///< of the mean variance of each degree of the scores

  static constexpr std::size_t LongestName = 100;

  std::string Name; ///< of the known organ's structure, at most LongestName bytes; may be empty
  ///@{ Scores of the known organs: their mean and standard deviations.
  Eigen::VectorXd Mean;
  Eigen::VectorXd Deviations;
  ///@}
  /// Of what is asked for, the unknown organ's scores and then its centroid, by those scores.
  Eigen::MatrixXd Gain;
  Eigen::MatrixXd Covariance;       ///< of the same, given the known organ
  Vector3 Offset = Vector3::Zero(); ///< mean of the unknown organ's centroid from the known one's
  ///@{ Distances of the unknown organ's points, at the parameters of WallFrequency, from the known
  /// surface, outside positive: mean and covariance.
  Eigen::VectorXd WallMean;
  Eigen::MatrixXd WallCovariance;
  ///@}

  /// Regression with a ridge: block Gaussian conditioning, with the scores' own covariance enlarged
  /// by Ridge. `asked` and `known` have a row for each case; `asked` has means of 0.
  void Regress(const Eigen::MatrixXd& asked, const Eigen::MatrixXd& known);
  /// `distances` has a row for each case.
  void TakeWalls(const Eigen::MatrixXd& distances);
  /// What is asked for, as `known` has it; Fails for an organ that is unlike the group's.
  Status Predict(const LogSurface& known, Eigen::VectorXd& expected) const;
  /// Fails unless the name is short, all numbers are finite and of these sizes, and the covariances
  /// positive definite.
  Status Check(Eigen::Index asked) const;
};

/// A model as ln(radius / mm) to degree 12 about its centroid, by least squares of points of its
/// surface, weighted by solid angle: what OrganRelation takes as known. Fails for a model that
/// encloses no volume or comes close to its centroid. Allocates.
Status FindLogSurface(const OrganModel& model, LogSurface& made);

/// Signed distances of points from a surface (mm, to first order), and their derivatives by the
/// points. Allocates.
class LogSurfaceDistance
{
public:
  explicit LogSurfaceDistance(LogSurface surface);
  void Evaluate(const Eigen::Matrix3Xd& points);
  const Eigen::VectorXd& Values() const noexcept { return this->Equations.Residuals(); }
  Eigen::Matrix3Xd Gradients() const { return -this->Equations.ByCenter(); }

private:
  LogSurface Surface;
  TouchEquations Equations;
};
} // namespace palpate
