#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Stands in the head of every page that Palpate writes.
inline constexpr const char* PageGenerator = "<meta name=\"generator\" content=\"Palpate\"/>";

/// Checks that a result with files of these names may replace what `folder` holds under them.
/// Throws InputError for a page (.html) that Palpate did not write, and for a .json or .touch
/// unless it or another of these names is recognised as Palpate's: by PageGenerator or, in older
/// pages, by the style sheet; by the format that models, scenes and recordings state at their
/// start. Meshes, tables and pictures state none and may be replaced, as empty files and links.
PALPATEIO_EXPORT void RequireEarlierFiles(const std::filesystem::path& folder,
                                          const std::vector<std::string>& names);

/// Throws InputError if both are the same existing file, also through links.
PALPATEIO_EXPORT void RequireOtherFile(const std::filesystem::path& output,
                                       const std::filesystem::path& input);
} // namespace palpate
