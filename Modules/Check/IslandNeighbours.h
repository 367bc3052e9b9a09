#pragma once

#include "CaseMasks.h"

namespace palpate
{
/// Names for each structure with several parts that one against which its island lies
/// (MaskStatistic::Other of "part"; empty if it touches none): the structure whose voxels share the
/// largest area of faces with the island. An island is the second largest part of the voxels, of
/// which those that share a corner are joined. Structures are on one grid.
void NameIslandNeighbours(const CaseMasks& masks, CheckedCase& patient);
} // namespace palpate
