#pragma once

#include "AvailableMemory.h"
#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Throws InputError where reading `dataBytes` of voxels from `file` needs more than
/// `availableBytes`. Counted twice: the format libraries decode into a buffer of their own.
PALPATEIO_EXPORT void CheckMemory(const std::filesystem::path& file, double dataBytes,
                                  std::uint64_t availableBytes);
} // namespace palpate
