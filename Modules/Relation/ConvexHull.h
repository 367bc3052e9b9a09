#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// The triangles, oriented outwards, of the convex hull of points (finite; sizes as exact::
/// needs); no triangles if all points lie in one plane. Points on a face of the hull that are not
/// its corners may be left out. After Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for
/// convex hulls", ACM Trans. Math. Softw. 22 (1996), with exact signs, so that points in a plane
/// need no tolerance.
IndexedMesh ConvexHullOf(const std::vector<Vector3>& points);
} // namespace palpate
