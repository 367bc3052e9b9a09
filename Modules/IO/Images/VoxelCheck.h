#pragma once

#include "PalpateIOModule.h"
#include "vtkDataArray.h"

#include <filesystem>

namespace palpate
{
/// Throws InputError if floating-point voxels are not finite (NaN, infinity).
PALPATEIO_EXPORT void CheckFinite(const std::filesystem::path& file, vtkDataArray* voxels);
} // namespace palpate
