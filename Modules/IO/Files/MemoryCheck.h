#pragma once

#include "AvailableMemory.h"
#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Throws InputError if reading `dataBytes` of voxels from `file` needs more than `availableBytes`.
/// The voxels count twice, since the format libraries decode into their own buffer.
PALPATEIO_EXPORT void CheckMemory(const std::filesystem::path& file, double dataBytes,
                                  std::uint64_t availableBytes);
} // namespace palpate
