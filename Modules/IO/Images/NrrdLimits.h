#pragma once

#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// Looks at an NRRD file before its library does, which copies lines and file names of any length
/// into messages of 1,024 letters, prints file numbers by a format that the file gives, has room
/// for 16 axes of which it writes a 17th, and searches all key/value pairs for each. Throws
/// InputError for a field of more than 512 letters, more than 10 dimensions, sizes
/// that are no positive int, more than 20,000 key/value pairs, data files other than regular ones,
/// and data files by a pattern.
PALPATEIO_EXPORT void CheckNrrdLimits(const std::filesystem::path& file);
} // namespace palpate
