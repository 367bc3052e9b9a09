#pragma once

#include "Vector3.h"

namespace palpate
{
class ComplianceAtlas;
class RadialModel;

/// What a rigid ball feels that is pressed into an elastic organ: minus the gradient of the energy
/// of BallContact by the ball's place. Its part along the normal is the force of the contact; the
/// lateral part, from the slopes of the compliance and of the curvature, keeps sliding contact from
/// giving out energy.
struct ElasticForce
{
  Vector3 ForceWorld = Vector3::Zero(); ///< on the ball, N
  double PatchRadius = 0.0;             ///< mm; a guess for the next tick
  double Energy = 0.0;                  ///< N mm
  double Slope = 0.0;                   ///< of the force along the normal by the depth, N/mm
  /// Whether linear elasticity and one patch describe the contact: the depth is at most half of
  /// the ball's radius and a fifth of the organ's, the patch could grow, and the ball fits.
  bool IsValid = true;

  /// For the nearest point of the model's surface to the ball's centre, in the unit vector
  /// `direction` from the model's, and the depth (mm) of the ball. `start` is the last patch's
  /// radius or 0. Does not allocate.
  static ElasticForce Of(const ComplianceAtlas& atlas, const RadialModel& model,
                         const Vector3& direction, double depth, double ballRadius,
                         double start = 0.0) noexcept;
};
} // namespace palpate
