#pragma once

#include "OrganRelation.h"
#include "Status.h"
#include "SurfaceModel.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
/// Where a surface is before it is touched: coefficients (mm, x, then y, then z, about the
/// centroid) Mean + the prior's modes times scores + a rest; scores and centroid are normal with
/// this covariance.
struct SurfaceDistribution
{
  Eigen::VectorXd Mean;
  Vector3 CentroidWorld = Vector3::Zero();
  Eigen::MatrixXd Covariance; ///< of the scores (mm), then of the centroid (mm)
};

/// What is known of an organ of any shape before it is touched, in the patient's axes: a group's
/// surfaces in correspondence as principal modes, the rest of which is as likely in every direction
/// and differs by degree only (probabilistic principal components, Tipping and Bishop, J. Royal
/// Statistical Society B 61, 1999). With OrganRelation, also what another organ says of it.
struct SurfacePrior
{
  static constexpr int LargestDegree = 20;
  static constexpr std::size_t LeastCases = 3;
  static constexpr Eigen::Index MostModes = 60;
  /// What few cases leave out of the modes is more in others than in themselves.
  static constexpr double RestFactor = 1.3;
  static constexpr double CentroidDeviation = 6.0; ///< of a click from the centroid, mm

  /// A case: its surface, about its centroid, where that is, and the other organ if it is known.
  struct Case
  {
    SurfaceModel Surface;
    Vector3 CentroidWorld = Vector3::Zero();
    std::optional<LogSurface> Known;
  };

  /// Of surfaces of one degree; the mirror images at x = 0 are cases, too, if that changes the mean
  /// by less than half of the cases' own spread. Fails for fewer than LeastCases, a degree above
  /// LargestDegree, and cases that are all equal. Allocates.
  static Status OfGroup(const std::vector<Case>& cases, SurfacePrior& prior);
  /// Fails unless the numbers, as a file has them, are a prior.
  Status Check() const;

  /// About a point near the centroid.
  SurfaceDistribution About(const Vector3& clickWorld) const;
  /// Given the other organ. Fails for a prior without a relation, and as OrganRelation::Predict.
  Status Given(const LogSurface& known, SurfaceDistribution& made) const;

  std::size_t Cases() const noexcept { return this->CaseCount; }

  int Degree = 0;
  Eigen::VectorXd Mean;      ///< mm: x, then y, then z
  Eigen::MatrixXd Modes;     ///< a column each, orthonormal
  Eigen::VectorXd Variances; ///< of their scores, mm^2
  Eigen::VectorXd Rest;      ///< variance of what is left of a coefficient, for each degree, mm^2
  std::size_t CaseCount = 0; ///< without mirror images
  std::optional<OrganRelation> Relation;
};
} // namespace palpate
