#pragma once

#include "DirectionCaster.h"
#include "IndexedMesh.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// 1 for each point inside a closed surface, else 0: rays from one start through the points leave
/// the surface once more than they enter it. Points on the surface count as either.
std::vector<std::uint8_t> InsideOf(const std::vector<Vector3>& points, const IndexedMesh& surface);

/// Whether the point at a distance (mm) along a ray lies inside a closed surface, of which these
/// are the ray's crossings: the rest of the ray leaves it once more than it enters.
bool IsWithinCrossings(const std::vector<RayCrossing>& crossings, double distance);
} // namespace palpate
