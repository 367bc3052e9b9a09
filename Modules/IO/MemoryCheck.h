#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Bytes that the machine can still give without swapping: MemAvailable of /proc/meminfo, or the
/// largest number where that cannot be read (then nothing is refused).
PALPATEIO_EXPORT std::uint64_t
AvailableMemoryBytes(const std::filesystem::path& meminfo = "/proc/meminfo");

/// Throws InputError where reading `dataBytes` of voxels from `file` needs more than
/// `availableBytes`. Counted twice: the format libraries decode into a buffer of their own.
PALPATEIO_EXPORT void CheckMemory(const std::filesystem::path& file, double dataBytes,
                                  std::uint64_t availableBytes);
} // namespace palpate
