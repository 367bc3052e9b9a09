#pragma once

#include "HalfEdgeMesh.h"
#include "ReferenceNormals.h"

namespace palpate
{
/// Evens out a surface's triangles, keeping its topology and, up to flips, its volume: each round
/// flips edges whose two triangles' opposite angles sum to more than pi, then moves every point
/// within the plane of its neighbours' boundary towards the area-weighted centroid of its
/// triangles. A change that would turn a triangle over is left out.
void RelaxSurface(HalfEdgeMesh& mesh, const ReferenceNormals& normals, int rounds);
} // namespace palpate
