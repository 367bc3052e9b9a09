#pragma once

#include "DirectionCaster.h"
#include "Vector3.h"

namespace palpate
{
/// Visibility of a closed surface from a point inside it.
struct StarShapeVerdict
{
  bool IsStarShaped = false;
  double HiddenPercent = 0.0; ///< of the surface's area: faces away, or lies behind other parts
};

/// Centroid of the volume that a closed mesh encloses.
Vector3 VolumeCentroid(const IndexedMesh& mesh);

/// Judges each triangle by its centroid: visible if its outward normal points away from the centre
/// and no other triangle lies before it. A closed surface is star-shaped if all its triangles are
/// visible. Up to 0.01 % of hidden area is accepted as star-shaped, since rounding causes as much
/// on a flat face seen edge-on.
StarShapeVerdict JudgeStarShape(const IndexedMesh& mesh, const Vector3& center);

/// The point from which most of the surface is visible: the best of a grid over the bounding box
/// and the volume centroid by the area that faces it, refined by a compass search on the visible
/// area (JudgeStarShape), down to a hundredth of the box. A heuristic: the function has several
/// maxima for branched shapes.
Vector3 MostVisibleCenter(const IndexedMesh& mesh);
} // namespace palpate
