#pragma once

#include "IndexedMesh.h"
#include "Status.h"

namespace palpate
{
/// Mends that do not change the surface as a set of points, except KeepPart. All indices
/// must be valid and the mesh have at most 700 million triangles and points; MendMesh checks that.

/// Merges points at exactly equal positions into the first of them, as STL files need. Returns the
/// number of points removed. Bounded time also for colliding hashes.
int WeldPoints(IndexedMesh& mesh);
/// Drops triangles with a repeated point; returns their number.
int DropDegenerateTriangles(IndexedMesh& mesh);
/// Keeps the first of triangles with the same three points, in any order; returns the number of the
/// others.
int DropDuplicateTriangles(IndexedMesh& mesh);
/// Drops points without triangles, keeping the order; returns their number.
int DropUnusedPoints(IndexedMesh& mesh);
/// Keeps one part (connected across edges), by its number in the order of decreasing area, from 1;
/// returns the number of the other parts. Points stay. A number beyond the last part changes
/// nothing.
int KeepPart(IndexedMesh& mesh, int number);
/// Reverses triangles so that all agree with the majority of their sheet, then every body whose
/// outermost sheet is inside out (OutermostSheets), with its cavities, which keep facing inwards.
/// Returns the number of triangles reversed. Leaves the mesh as it is if it is one-sided.
int OrientOutwards(IndexedMesh& mesh);

/// What MendMesh changed.
struct MeshMends
{
  int WeldedPoints = 0;
  int DroppedTriangles = 0; ///< degenerate
  int Duplicates = 0;       ///< triangles that were there twice
  int DroppedParts = 0;     ///< other parts than the one that was asked for
  int DroppedPoints = 0;
  int ReversedTriangles = 0;
};

/// All of the above in this order; `part` is that of KeepPart, or 0 for all. Fails for points that
/// are not finite, for invalid indices, and if there is no part of that number, which leaves the
/// mesh as it is but for the steps before.
Status MendMesh(IndexedMesh& mesh, int part, MeshMends& mends);
} // namespace palpate
