#pragma once

#include "OrganModel.h"
#include "RadialModel.h"
#include "Status.h"
#include "SurfaceModel.h"

namespace palpate
{
/// Common axes of the models of a cohort.
enum class AlignmentAxes
{
  Patient,   ///< the frame's axes, unchanged
  Ellipsoid, ///< the body's principal axes
  Procrustes ///< the orientation closest to the mean (AlignByProcrustes); Patient for one shape
};

/// Moves a model's centre to the origin and, for Ellipsoid, rotates it so that its body extends
/// most along x, less along y and least along z. The coefficients are rotated by
/// an exact quadrature (SphericalHarmonicProjection); the centre is the model's own, which a fit
/// places at the structure's centroid, since about any other point the radii would not be a finite
/// sum of harmonics.
///
/// An ellipsoid is symmetric under rotations by pi about its axes, so the third moments about the
/// centroid decide: of the three axes the two along which the body is most skewed (third moment
/// over second to the power 3/2) point to its longer tail, and the third makes them right-handed.
/// So copies of a body in any orientation align to each other up to rounding divided by the
/// difference of the two closest second moments; if two of these, or two tails, are equal, the
/// result is arbitrary. Fails where MeasureBody does. Allocates.
Status AlignShape(const RadialModel& model, AlignmentAxes axes, RadialModel& aligned);
/// The same for a surface model, whose centroid moves to the origin; its parameters turn with
/// it.
Status AlignShape(const SurfaceModel& surface, AlignmentAxes axes, SurfaceModel& aligned);
/// Of either kind.
Status AlignShape(const OrganModel& shape, AlignmentAxes axes, OrganModel& aligned);
} // namespace palpate
