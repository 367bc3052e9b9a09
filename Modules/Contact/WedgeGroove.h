#pragma once

#include "TouchableSurfaceModel.h"
#include "Vector3.h"

namespace palpate
{
/// The groove between two walls that a sphere touches, and how much of a step through it leads to
/// the place nearest to a goal. Far from a goal behind walls that curve, the place that their
/// planes allow moves back many times faster than the sphere goes on, so that whole steps would go
/// to and fro for ever. Newton's method takes the curvature of the walls into account.
class WedgeGroove
{
public:
  /// None: steps are taken as they are.
  WedgeGroove() = default;
  /// Between two walls that push the sphere from the goal to the place that their planes allow
  /// (`push`, mm, a sum of their normals).
  WedgeGroove(const TouchableSurfaceModel::ClosestPoint& one,
              const TouchableSurfaceModel::ClosestPoint& other, const Vector3& push) noexcept;

  bool IsKnown() const noexcept { return this->Part > 0.0; }
  /// The part of a step to the place that the planes allow.
  Vector3 Newton(const Vector3& step) const noexcept
  {
    return this->IsKnown()
               ? Vector3(step + (this->Part - 1.0) * step.dot(this->Along) * this->Along)
               : step;
  }

private:
  Vector3 Along = Vector3::Zero(); // unit vector
  double Part = 0.0;
};
} // namespace palpate
