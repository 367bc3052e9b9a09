#pragma once

#include "PalpateIOModule.h"
#include "vtkDataArray.h"

#include <filesystem>

namespace palpate
{
/// Whether a newly written image file holds exactly these one-component voxels: their type and all
/// their bits, not the geometry. Throws std::exception if it cannot be read.
PALPATEIO_EXPORT bool HoldsVoxels(const std::filesystem::path& file, vtkDataArray* voxels);
} // namespace palpate
