#pragma once

#include "ContactForce.h"
#include "Status.h"
#include "SurfaceFriction.h"

namespace palpate
{
/// Limits of what a program may ask of a structure, so that a wrong unit is noticed.
struct ContactLimits
{
  /// N/mm. Several times what the stiffest haptic devices hold (see StiffestStable): above it every
  /// device switches between no force and its largest one.
  static constexpr double Stiffness = 100.0;
  static constexpr double Damping = 10.0;     ///< N s/mm
  static constexpr double Friction = 10.0;    ///< coefficient
  static constexpr double ToolRadius = 100.0; ///< mm
  static constexpr double LeastScale = 1e-3;  ///< mm of the scene for one of the hand
  static constexpr double LargestScale = 1e3;

  /// Fails, naming the quantity and its limits, if a law or a friction is negative, not finite or
  /// beyond them, or if the sliding friction is above the static one.
  static Status Check(const ContactLaw& law, const SurfaceFriction& friction);
};
} // namespace palpate
