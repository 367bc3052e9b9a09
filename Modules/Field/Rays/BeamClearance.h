#pragma once

#include "RayCaster.h"

namespace palpate
{
/// Rays side by side, as those of a part of a picture: at each t, all of them lie within a box
/// round the middle ray (index frame, voxels), whose half-size grows with t.
struct FieldBeam
{
  FieldRay Middle;
  Vector3 HalfSize = Vector3::Zero(); ///< at t = 0
  Vector3 Growth = Vector3::Zero();   ///< of the half-size per t
};

/// The beam of the rays between four corner rays; origins and directions of all of them are
/// weighted means of the corners'.
FieldBeam BeamOf(const FieldRay (&cornersIndex)[4]) noexcept;

/// No ray of the beam meets a surface for tMin <= t < the answer, which is tMax where there is none
/// at all. What is so skipped changes no hit (see RayCaster). Conservative: the beam is followed
/// through empty bricks, and then through cells without a surface, until it may touch one that has.
double ClearUntil(const ScalarField& field, const FieldBeam& beamIndex, double tMin,
                  double tMax) noexcept;
} // namespace palpate
