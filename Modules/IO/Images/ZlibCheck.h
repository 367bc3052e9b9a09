#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Decodes the zlib or gzip data of a file from byte `start` to their end, which lies within
/// `mostBytes` of it, without keeping them; zlib checks their checksum. Returns their decoded
/// length in bytes. Throws InputError naming `file` where they end early, do not decode, or go on
/// for more than a megabyte behind the `dataBytes` that are wanted of them.
PALPATEIO_EXPORT std::uint64_t CheckedInflatedBytes(const std::filesystem::path& file,
                                                    std::uint64_t start, std::uint64_t dataBytes,
                                                    std::uint64_t mostBytes = UINT64_MAX);

/// Throws InputError if `packedBytes` of zlib or gzip data of `file` cannot hold `dataBytes`, so
/// that nothing is allocated for them: no byte of such data becomes more than 1,032.
PALPATEIO_EXPORT void CheckInflatedSize(const std::filesystem::path& file, double packedBytes,
                                        double dataBytes);
} // namespace palpate
