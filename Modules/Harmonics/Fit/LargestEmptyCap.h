#pragma once

#include "SphericalTriangle.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// The largest cap whose interior contains none of the unit vectors, by branch and bound over
/// triangles of a subdivided icosahedron: no cap is larger by more than `tolerance` (rad, above
/// 1e-4). Every triangle keeps only the directions that may be closest to one of its points.
/// Takes milliseconds for thousands of directions. Without a direction the whole sphere (radius pi)
/// is empty.
SphericalCap LargestEmptyCap(const std::vector<Vector3>& directions, double tolerance);
} // namespace palpate
