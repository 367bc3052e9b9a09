#pragma once

#include "EdgeRings.h"
#include "IndexedMesh.h"
#include "MeshSheets.h"

#include <vector>

namespace palpate
{
/// For each sheet of a mesh the sheet whose orientation decides about it: the outermost one that
/// encloses it, or itself. A cavity and what lies in it belong to the body around them, a body
/// beside the largest to itself. `volumes` are those that the sheets enclose, of either sign, and
/// not empty.
///
/// Outermost are sheets of at least a hundredth of the largest one's volume, at most 16; those that
/// are not closed, and sheets that none of these encloses, go with the largest. Enclosed is a large
/// sheet in the box of another, give or take a twentieth, whose solid angle is more than half of
/// the sphere at most of five places on it; a small one if its box lies in that of the other. Time:
/// at most that of 80 solid angles for each triangle, usually of a few.
std::vector<int> OutermostSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                 const MeshSheets& sheets, const std::vector<double>& volumes);
} // namespace palpate
