#pragma once

#include "FieldMaterial.h"
#include "Vector3.h"

namespace palpate
{
enum class HitKind
{
  Missed,  ///< no boundary between the two parameters
  Surface, ///< where a material begins or ends
  Border,  ///< where the ray enters or leaves the grid inside a material, which ends there
  BadRay   ///< a number that is not finite, or a direction of zero length: no result
};

/// The first boundary on a ray, origin + t direction. Position and gradient are in the frame of the
/// query.
struct FieldHit
{
  HitKind Kind = HitKind::Missed;
  bool IsEntering = false;      ///< into the material, else out of it
  int Material = -1;            ///< whose boundary it is; the lowest number where several share it
  MaterialSet StartsInside = 0; ///< of the requested materials, those in which the ray starts
  double T = 0.0;
  Vector3 Position = Vector3::Zero();
  /// Gradient of the condition's margin that changes sign here, so that the outward normal is minus
  /// this, normalised, whatever the condition's sense. At the border it points into the grid,
  /// normal to its face, with a length of 1 per voxel.
  Vector3 Gradient = Vector3::Zero();
};
} // namespace palpate
