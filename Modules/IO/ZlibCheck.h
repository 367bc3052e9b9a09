#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Decodes the zlib or gzip data of a file from byte `start` to their end, which lies within
/// `mostBytes` of it, without keeping them; zlib checks their checksum. Returns their decoded
/// length in bytes. Throws InputError naming `file` where they end early or do not decode.
PALPATEIO_EXPORT std::uint64_t CheckedInflatedBytes(const std::filesystem::path& file,
                                                    std::uint64_t start,
                                                    std::uint64_t mostBytes = UINT64_MAX);
} // namespace palpate
