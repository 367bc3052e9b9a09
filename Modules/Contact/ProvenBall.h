#pragma once

#include "Vector3.h"

namespace palpate
{
/// A place with a lower bound of its distance from a surface, by a proof or by trials, which bounds
/// that of other places too: a distance changes by at most as much as the place moves.
struct ProvenBall
{
  Vector3 CenterWorld = Vector3::Zero(); ///< mm
  double Distance = 0.0;                 ///< mm, of all of the surface; 0 if unknown

  /// The bound at another place, mm; negative where nothing is known.
  double DistanceAt(const Vector3& placeWorld) const noexcept
  {
    return this->Distance - (placeWorld - this->CenterWorld).norm();
  }
};
} // namespace palpate
