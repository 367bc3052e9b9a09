#pragma once

#include "IndexedMesh.h"
#include "NearestOnMesh.h"
#include "PalpateFiltersModule.h"
#include "Status.h"

namespace palpate
{
/// What lies under a point of a closed surface, perpendicular to it.
struct WallThickness
{
  Vector3 PointOnSurface = Vector3::Zero();
  Vector3 OppositePoint = Vector3::Zero(); ///< where the wall ends
  double Thickness = 0.0;                  ///< mm
};

/// Measured from the surface's point nearest to `point` (mm), along the inward normal, to the next
/// crossing of the surface: the far side of a solid, the inner side of a shell. The normal is
/// interpolated from those of the triangle's corners: of the triangles around them up to edges of
/// 40 degrees, weighted by their angles. `nearest` is of the same mesh. Orientation does not
/// matter: inwards is where an odd number of crossings follows. Fails if that is so on neither
/// side, at a hole.
PALPATEFILTERS_EXPORT Status MeasureThickness(const IndexedMesh& mesh, const NearestOnMesh& nearest,
                                              const Vector3& point, WallThickness& measured);
} // namespace palpate
