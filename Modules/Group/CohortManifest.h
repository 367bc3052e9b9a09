#pragma once

#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// One case of a cohort.
struct CohortCase
{
  std::string Name;             ///< its row's and its folder's, no two alike
  std::filesystem::path Mask;   ///< whether it can be read shows when its turn comes
  std::string Label;            ///< by number or name; empty for every structure
  std::filesystem::path Volume; ///< for the report's slices; empty for none
};

/// The cases of a table with a head `case,mask,label,volume`, a row a case; only `case` and `mask`
/// must be there, in any order and beside others. Paths are relative to `base`, or to the table's
/// own folder where that is empty. Throws InputError where the table is none, has no row, or two
/// cases would have one name (names are compared in the letters that folders get).
PALPATEGROUP_EXPORT std::vector<CohortCase> ReadManifest(const std::filesystem::path& file,
                                                         const std::filesystem::path& base = {});

/// The images of a folder, not of those below it, by rising name. Throws InputError where there is
/// none.
PALPATEGROUP_EXPORT std::vector<std::filesystem::path>
FindMasks(const std::filesystem::path& folder);
} // namespace palpate
