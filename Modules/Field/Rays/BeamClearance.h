#pragma once

#include "RayCaster.h"

namespace palpate
{
/// A bundle of neighbouring rays, such as those of an image tile: at each t, all of them lie within
/// a box around the central ray (index frame, voxels), whose half-size grows with t.
struct FieldBeam
{
  FieldRay Center;
  Vector3 HalfSize = Vector3::Zero(); ///< at t = 0
  Vector3 Growth = Vector3::Zero();   ///< of the half-size per t
};

/// The beam between four corner rays; origins and directions of all its rays are weighted means of
/// those of the corners.
FieldBeam BeamOf(const FieldRay (&cornersIndex)[4]) noexcept;

/// No ray of the beam meets a surface for tMin <= t < the result, which is tMax if there is none at
/// all. Skipping this interval changes no hit (see RayCaster). Conservative: the beam is traced
/// through empty bricks, and then through cells without a surface, until it may touch one with a
/// surface.
double ClearUntil(const ScalarField& field, const FieldBeam& beamIndex, double tMin,
                  double tMax) noexcept;
} // namespace palpate
