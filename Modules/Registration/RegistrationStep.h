#pragma once

#include "Vector3.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace palpate
{
/// What a registration may change.
enum class RegistrationKind
{
  Rigid,      ///< position and orientation
  Similarity, ///< and size
  Affine      ///< any linear map
};

/// Small changes of a map about a pivot, in unknowns that are all lengths: mm of shift, and mm at
/// the distance `Radius` from the pivot of turn, of growth, and of the nine entries of a matrix.
class RegistrationStep
{
public:
  RegistrationStep(RegistrationKind kind, const Vector3& pivot, double radius)
      : Kind(kind), Pivot(pivot), Radius(radius)
  {
  }

  int Count() const noexcept;
  /// The derivatives, by the unknowns, of a point's coordinate along a direction.
  Eigen::VectorXd Derivatives(const Vector3& point, const Vector3& direction) const;
  /// The map that these unknowns make: orthogonal times a size, or any.
  Eigen::Affine3d MapOf(const Eigen::VectorXd& unknowns) const;

private:
  RegistrationKind Kind;
  Vector3 Pivot;
  double Radius;
};

/// What a registration's equations say of its own error: standard deviations of turn (rad) and
/// shift (mm) about the pivot, all axes together; infinite if the points do not determine them.
struct PredictedPoseError
{
  /// `normal` is J^T W J of a step whose first six unknowns are shift and turn; `noise` is the
  /// standard deviation of a point's coordinate (mm).
  static PredictedPoseError Of(const Eigen::MatrixXd& normal, double radius, double noise);

  double Turn = 0.0;
  double Shift = 0.0;
};
} // namespace palpate
