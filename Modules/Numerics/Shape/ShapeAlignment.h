#pragma once

#include "SphericalHarmonicModel.h"
#include "Status.h"

namespace palpate
{
/// Which axes the models of a cohort share.
enum class AlignmentAxes
{
  Patient,  ///< the frame's own, as they are
  Ellipsoid ///< the body's principal ones
};

/// Moves a model's centre to the origin and, for Ellipsoid, turns it so that its body extends most
/// along x, less along y and least along z. The coefficients are turned exactly
/// (SphericalHarmonicRotation); the centre is the model's own, which a fit puts at the structure's
/// centroid, since about any other point the radii would be no finite sum of harmonics.
///
/// An ellipsoid looks the same turned about its axes by pi, so the third moments about the centroid
/// decide: of the three axes the two along which the body is most skewed (third moment over second
/// to the power 3/2) point to its longer tail, and the third makes them right-handed. So copies of
/// a body, turned in any way, align to each other up to rounding over the distance of the two
/// closest second moments; where two of these are alike, or two tails, the answer is arbitrary.
/// Fails where MeasureBody does. Allocates.
Status AlignShape(const SphericalHarmonicModel& model, AlignmentAxes axes,
                  SphericalHarmonicModel& aligned);
} // namespace palpate
