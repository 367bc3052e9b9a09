#pragma once

#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// Whether a folder for results can be made and written to, asked before long work and without
/// making it. Throws InputError where it cannot: a part of its path is no folder, or forbids it.
PALPATEIO_EXPORT void CheckOutputFolder(const std::filesystem::path& folder);

/// Makes a folder for results, and those above it. Throws InputError where that fails.
PALPATEIO_EXPORT void MakeOutputFolder(const std::filesystem::path& folder);
} // namespace palpate
