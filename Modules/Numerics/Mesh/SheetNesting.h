#pragma once

#include "EdgeRings.h"
#include "IndexedMesh.h"
#include "MeshSheets.h"

#include <vector>

namespace palpate
{
/// For each sheet of a mesh the sheet whose orientation decides about it: the outermost one that
/// encloses it, or itself. A cavity and what lies in it belong to the body around them, a body
/// beside the largest to itself. `volumes` are those that the sheets enclose, of either sign.
///
/// Outermost are sheets of at least a hundredth of the largest one's volume, at most 32 of them;
/// those that are not closed, and sheets that none of these encloses, go with the largest. Enclosed
/// is a sheet of which most triangles have their centre in voxels inside the other one, 48 along
/// each axis of its box. Time: that of some operations for each triangle and outermost sheet.
std::vector<int> OutermostSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                 const MeshSheets& sheets, const std::vector<double>& volumes);
} // namespace palpate
