#pragma once

#include "PatchCompliance.h"

namespace palpate
{
/// Contact of a rigid ball with an elastic place, as one problem in the force F and the radius a of
/// the patch: for the depth d of the ball in the undeformed surface the energy is the stationary
/// value of
///
///     U = F (d - h(a)) - F^2 c(a) / 2,     h = a^2/5 (1/r + H) + a^4/35 (1/r^3 + H^3) + ...
///
/// with the mean gap h, over a Hertz bump, between a ball of radius r and a surface of mean
/// curvature H. So F = -2 h'/c' and d = h - 2 h' c/c'; on a half-space that is Hertz' solution. A
/// patch that can grow no more keeps its size: then the force goes on linearly, with the slope 1/c.
/// It does not grow to where a larger one would yield more.
struct BallContact
{
  double Force;       ///< N
  double PatchRadius; ///< mm
  double Energy;      ///< N mm
  double Slope;       ///< of the force by the depth, N/mm
  bool IsPatchFull;   ///< whether the patch has its largest size

  /// `depth` >= 0 and `ballRadius` > 0 in mm; `meanCurvature` in 1/mm, greater than -1/ballRadius.
  /// `start` is a guess of the patch's radius (mm), as of the last tick, or 0. No contact for a
  /// depth that is not positive, or where the ball does not fit. Does not allocate.
  static BallContact Of(double depth, double ballRadius, double meanCurvature,
                        const PatchCompliance& place, double start = 0.0) noexcept;

  /// Derivative of the energy by the curvature at the same depth, N mm^2.
  double EnergyByCurvature(double meanCurvature) const noexcept;
};
} // namespace palpate
