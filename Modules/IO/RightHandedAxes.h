#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// Reverses one index axis of a left-handed grid: the voxels are reordered in place, the origin
/// moves to the other end, and every voxel stays where it is in the world. The axis that points
/// most against its patient axis is taken (so the result is closest to L, P, S), and the slice axis
/// where none does. Returns a sentence that says so, empty where the grid is right-handed.
PALPATEIO_EXPORT std::string MakeRightHanded(ImageGrid& grid, vtkDataArray* voxels);
} // namespace palpate
