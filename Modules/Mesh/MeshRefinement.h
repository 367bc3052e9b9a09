#pragma once

#include "IndexedMesh.h"

namespace palpate
{
/// Splits all edges that are longer than `longest` (mm) at their midpoints, in passes that halve
/// them, until none is left or a pass would give more than `mostTriangles`. So large faces get as
/// many points as their area asks for. The surface as a set of points, its topology and
/// orientation stay, up to the rounding of midpoints. Points keep their numbers; new ones follow.
/// The indices must be valid, and the points finite. Returns whether no long edge is left.
bool SplitLongEdges(IndexedMesh& mesh, double longest, int mostTriangles);
} // namespace palpate
