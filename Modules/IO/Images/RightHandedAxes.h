#pragma once

#include "ImageGrid.h"
#include "LeftHandedAxes.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Makes a left-handed grid right-handed; returns an empty text if the grid already is. Throws
/// InputError for a left-handed one if `handling` is to refuse. Otherwise one index axis is
/// reversed: the voxels are reordered in place, the origin moves to the other end, and every voxel
/// keeps its position in the world. The axis that points most against its patient axis is reversed
/// (so the result is closest to L, P, S), or the slice axis if none does. Returns a note on the
/// reversal.
PALPATEIO_EXPORT std::string MakeRightHanded(const std::filesystem::path& file,
                                             LeftHandedAxes handling, ImageGrid& grid,
                                             vtkDataArray* voxels);
} // namespace palpate
