#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// Whether a name looks like that of a file, "liver.msh": up to five letters and digits after its
/// last point, of one case and the first of them a letter, and no folder of that name exists.
PALPATEIO_EXPORT bool HasFileEnding(const std::filesystem::path& path);

/// Checks, before long work, that a folder for results can be created and written to, without
/// creating it. Throws InputError if a part of its path is not a folder or does not
/// permit it, and for the name of a file (HasFileEnding).
PALPATEIO_EXPORT void CheckOutputFolder(const std::filesystem::path& folder);

/// Creates a folder for results and its parents. Throws InputError if that fails.
PALPATEIO_EXPORT void MakeOutputFolder(const std::filesystem::path& folder);

/// Writes the files of one result: all of them, or none. `write` receives a temporary folder inside
/// `folder`; when it returns, its files replace those of the same names in `folder`. Then the
/// `obsolete` files of an earlier result that `write` did not write are removed. If anything throws
/// before, `folder` is unchanged, or removed if it was new. Throws InputError, with the final names
/// of the files, also if one of them is not an earlier result (RequireEarlierFiles).
PALPATEIO_EXPORT void
WriteOutputSet(const std::filesystem::path& folder,
               const std::function<void(const std::filesystem::path& folder)>& write,
               const std::vector<std::string>& obsolete = {});
} // namespace palpate
