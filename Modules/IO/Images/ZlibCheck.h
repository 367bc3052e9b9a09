#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Decodes the zlib or gzip data of a file from byte `start` to their end, within `mostBytes` of
/// it, without storing them; zlib checks their checksum. Returns their decoded length in bytes.
/// Throws InputError naming `file` if they end early, do not decode, or continue for more than a
/// megabyte beyond the needed `dataBytes`.
PALPATEIO_EXPORT std::uint64_t CheckedInflatedBytes(const std::filesystem::path& file,
                                                    std::uint64_t start, std::uint64_t dataBytes,
                                                    std::uint64_t mostBytes = UINT64_MAX);

/// Throws InputError if `packedBytes` of zlib or gzip data of `file` cannot hold `dataBytes`,
/// before anything is allocated for them: no compressed byte decodes to more than 1,032.
PALPATEIO_EXPORT void CheckInflatedSize(const std::filesystem::path& file, double packedBytes,
                                        double dataBytes);
} // namespace palpate
