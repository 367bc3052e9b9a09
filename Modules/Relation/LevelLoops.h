#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// A closed curve, without the first point again at its end (mm).
using Loop = std::vector<Vector3>;

/// The curves of a closed, oriented surface at which `values` (at its points, linear in the
/// triangles, not NaN) are 0. Points with 0 count as above it, so that no curve runs through one.
std::vector<Loop> LevelLoopsOf(const IndexedMesh& mesh, const std::vector<double>& values);

/// mm.
double LengthOf(const Loop& loop);

/// What a loop encloses in a plane.
struct LoopSection
{
  double Area = 0.0;                ///< mm^2
  Vector3 Center = Vector3::Zero(); ///< the centroid
  double Least = 0.0;               ///< mm: the least distance of two parallel lines around it
  double Largest = 0.0;             ///< and the largest, in directions 2 degrees apart
};

/// Of a loop in a plane with this unit normal; no area without three points.
LoopSection SectionOf(const Loop& loop, const Vector3& normal);
/// Its area and centroid alone.
LoopSection EnclosedBy(const Loop& loop, const Vector3& normal);
} // namespace palpate
