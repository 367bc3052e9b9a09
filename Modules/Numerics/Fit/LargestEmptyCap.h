#pragma once

#include "SphericalTriangle.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// The largest cap whose inside holds none of the unit vectors: found by branch and bound over ever
/// smaller triangles of an icosahedron, so that no cap is larger by more than `tolerance` (rad,
/// above 1e-4). Every triangle keeps only the directions that may be nearest to some point of it.
/// Milliseconds for thousands of directions. Without a direction the whole sphere (radius pi) is
/// empty.
SphericalCap LargestEmptyCap(const std::vector<Vector3>& directions, double tolerance);
} // namespace palpate
