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
/// stays where it is in the world. The axis that points most against its patient axis is taken (so
/// the result is closest to L, P, S), and the slice axis where none does. Returns a sentence that
/// says so.
PALPATEIO_EXPORT std::string MakeRightHanded(const std::filesystem::path& file,
                                             LeftHandedAxes handling, ImageGrid& grid,
                                             vtkDataArray* voxels);
} // namespace palpate
