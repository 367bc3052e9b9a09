#pragma once

#include "FieldMaterial.h"
#include "Vector3.h"

namespace palpate
{
enum class HitKind
{
  Missed,  ///< no boundary between the two parameters
  Surface, ///< where a material's condition begins or ceases to hold
  Border,  ///< where the ray enters or leaves the grid inside a material, which ends there
  BadRay   ///< a number that is none, or a direction without length: no answer
};

/// The first boundary on a ray, origin + t direction. Position and gradient are in the frame that
/// the question was asked in.
struct FieldHit
{
  HitKind Kind = HitKind::Missed;
  bool IsEntering = false;      ///< into the material, else out of it
  int Material = -1;            ///< whose boundary it is; the lowest number where several share it
  MaterialSet StartsInside = 0; ///< of the materials asked for, those that the ray begins in
  double T = 0.0;
  Vector3 Position = Vector3::Zero();
  /// Of how far the condition holds that changes here, so that the outward normal is minus this,
  /// normalised, whatever the condition's sense. At the border it points into the grid, across its
  /// face, with a length of 1 per voxel.
  Vector3 Gradient = Vector3::Zero();
  /// How far from T rounding may have put the interpolated field's own boundary. A ray that only
  /// grazes the surface may have none there: then the value differs from the iso-value by rounding.
  double ErrorT = 0.0;
  double ErrorLength = 0.0; ///< the same along the ray, in mm
};
} // namespace palpate
