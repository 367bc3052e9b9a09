#pragma once

#include "PalpateIOModule.h"
#include "vtkDataArray.h"

#include <filesystem>

namespace palpate
{
/// Whether an image file that was just written, without its place, holds exactly these
/// one-component voxels: their type and all their bits. Throws std::exception where it cannot be
/// read.
PALPATEIO_EXPORT bool HoldsVoxels(const std::filesystem::path& file, vtkDataArray* voxels);
} // namespace palpate
