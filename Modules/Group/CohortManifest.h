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
  std::string Name;             ///< name of its row and folder, unique
  std::filesystem::path Mask;   ///< or a closed surface; not checked until it is processed
  std::string Label;            ///< by number or name; empty for every structure
  std::filesystem::path Volume; ///< for the report's slices; empty for none
};

/// The cases of a table with a header `case,mask,label,volume`, one row per case; only the columns
/// `case` and `mask` are required, in any order, and others may be present. Paths are relative to
/// `base`, or to the table's own folder if that is empty. Throws InputError if the file is not such
/// a table, has no rows, or two cases would have the same folder name.
PALPATEGROUP_EXPORT std::vector<CohortCase> ReadManifest(const std::filesystem::path& file,
                                                         const std::filesystem::path& base = {});

/// Throws InputError, beginning with `source`, if two cases would have the same folder name or one
/// none.
PALPATEGROUP_EXPORT void CheckCaseNames(const std::filesystem::path& source,
                                        const std::vector<CohortCase>& cases);

/// The images of a folder, or its surfaces if it has no image, not of its subfolders, sorted by
/// name. Throws InputError if there are none.
PALPATEGROUP_EXPORT std::vector<std::filesystem::path>
FindMasks(const std::filesystem::path& folder);
} // namespace palpate
