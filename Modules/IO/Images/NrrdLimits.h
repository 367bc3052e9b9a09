#pragma once

#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// Checks an NRRD file before its library reads it. The library copies lines and file names of any
/// length into messages of 1,024 characters, prints file numbers with a format string from the
/// file, writes a 17th axis into arrays of 16, and searches all key/value pairs for each new one.
/// Throws InputError for a field of more than 512 characters, more than 10 dimensions, sizes that
/// are not a positive int, more than 20,000 key/value pairs, data files that are not regular files,
/// and data files by a pattern.
PALPATEIO_EXPORT void CheckNrrdLimits(const std::filesystem::path& file);
} // namespace palpate
