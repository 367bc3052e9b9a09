#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// Whether a folder for results can be made and written to, asked before long work and without
/// making it. Throws InputError where it cannot: a part of its path is no folder, or forbids it.
PALPATEIO_EXPORT void CheckOutputFolder(const std::filesystem::path& folder);

/// Makes a folder for results, and those above it. Throws InputError where that fails.
PALPATEIO_EXPORT void MakeOutputFolder(const std::filesystem::path& folder);

/// Writes the files of one result: all of them, or none. `write` gets a temporary folder inside
/// `folder`; what it writes there replaces files of these names in `folder` once all is written.
/// Then the `obsolete` files of an earlier result that `write` did not write are removed. If
/// anything throws before, `folder` is as it was, and does not exist if it did not. Throws
/// InputError, in which the files have their final names.
PALPATEIO_EXPORT void
WriteOutputSet(const std::filesystem::path& folder,
               const std::function<void(const std::filesystem::path& folder)>& write,
               const std::vector<std::string>& obsolete = {});
} // namespace palpate
