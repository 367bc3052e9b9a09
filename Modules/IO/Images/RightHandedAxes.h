#pragma once

#include "ImageGrid.h"
#include "LeftHandedAxes.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Makes a left-handed grid right-handed. Throws InputError for a left-handed one if `handling` is
/// to refuse. Otherwise one index axis is reversed: the voxels are reordered in place, the origin
/// moves to the other end, every voxel keeps its position in the world, and a note is added. The
/// axis that points most against its patient axis is reversed (so the result is closest to L, P,
/// S), or the slice axis if none does.
PALPATEIO_EXPORT void MakeRightHanded(const std::filesystem::path& file, LeftHandedAxes handling,
                                      ImageGrid& grid, vtkDataArray* voxels,
                                      std::vector<std::string>& notes);
} // namespace palpate
