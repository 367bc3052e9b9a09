#pragma once

#include "SurfacePrior.h"

#include <Eigen/Core>

#include <memory>

namespace palpate
{
/// Linear functions of a surface, a column each: with x_k the coefficients of coordinate k and c
/// the centroid, sum_k Axis_k (Harmonics . x_k + Moves c_k).
struct SurfaceRows
{
  Eigen::MatrixXd Harmonics; ///< (degree + 1)^2 each
  Eigen::Matrix3Xd Axes;
  Eigen::RowVectorXd Moves; ///< 1 for points; 0 for tangents, which do not move with the centroid

  void Resize(Eigen::Index size, Eigen::Index count);
  Eigen::Index Count() const noexcept { return this->Axes.cols(); }
};

/// The normal distribution of a surface, given linear observations: closed form, with the prior's
/// covariance as modes plus a diagonal, which is never formed. Not thread-safe.
class SurfacePosterior
{
public:
  SurfacePosterior(std::shared_ptr<const SurfacePrior> prior, SurfaceDistribution before);

  /// Observations of `rows` with these values and covariance of their noise (positive definite).
  /// Replaces former ones. Allocates.
  void Condition(const SurfaceRows& rows, const Eigen::VectorXd& values,
                 const Eigen::MatrixXd& noise);

  ///@{ The mean: coefficients (mm) about the centroid, and that.
  const Eigen::VectorXd& Coefficients() const noexcept { return this->Mean; }
  const Vector3& CentroidWorld() const noexcept { return this->Centroid; }
  ///@}
  /// What rows see of the mean before and after.
  Eigen::VectorXd Before(const SurfaceRows& rows) const;
  Eigen::VectorXd After(const SurfaceRows& rows) const;
  /// Covariance of what rows see, or its diagonal alone. Allocate.
  Eigen::MatrixXd Covariance(const SurfaceRows& rows) const;
  Eigen::VectorXd Variances(const SurfaceRows& rows) const;

private:
  Eigen::MatrixXd ScoresOf(const SurfaceRows& rows) const;
  Eigen::MatrixXd RestBetween(const SurfaceRows& one, const SurfaceRows& other) const;
  Eigen::MatrixXd Known(const SurfaceRows& rows, const Eigen::MatrixXd& scores) const;

  std::shared_ptr<const SurfacePrior> Given;
  SurfaceDistribution Start;
  Eigen::VectorXd RestVariances; // of each harmonic
  Eigen::VectorXd Mean;
  Vector3 Centroid;
  SurfaceRows Seen;
  Eigen::MatrixXd SeenScores; // covariance of scores and centroid with what is seen
  Eigen::MatrixXd Factor;     // lower, of the covariance of what is seen
};
} // namespace palpate
