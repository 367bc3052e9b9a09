#pragma once

#include "EdgeRings.h"
#include "IndexedMesh.h"
#include "MeshSheets.h"

#include <vector>

namespace palpate
{
/// For each sheet of a mesh the outermost sheet that encloses it, or the sheet itself: a cavity and
/// what lies in it belong to the body around them, a second body beside the first to itself.
/// `volumes` are those that the sheets enclose, of either sign.
///
/// Sheets count as enclosed by the largest one unless they are closed, enclose at least a hundredth
/// of its volume, and are among the 32 largest, which bounds the time by 32 times that of a sum
/// over the triangles. Enclosed is a sheet whose box lies in that of the other and around whose
/// first point the other's solid angle is more than half of the sphere (van Oosterom and Strackee,
/// IEEE Trans. Biomed. Eng. 30 (1983)).
std::vector<int> OutermostSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                 const MeshSheets& sheets, const std::vector<double>& volumes);
} // namespace palpate
