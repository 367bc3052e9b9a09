#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <optional>
#include <string>

namespace palpate
{
/// A file that Palpate knows and does not read.
struct ForeignFile
{
  std::string Is;     ///< "is a legacy VTK file (POLYDATA), a surface"
  std::string WayOut; ///< "save it as .vtp"
};

/// What a file is by its first bytes (decompressed where it is a gzip file) or, failing that, by
/// the end of its name; nothing for a file that is not known. Reads at most 512 bytes of its
/// content.
PALPATEIO_EXPORT std::optional<ForeignFile> RecognizeForeignFile(const std::filesystem::path& file);

/// Throws InputError with what the file is, if that is known, else with this fact and way out.
[[noreturn]] PALPATEIO_EXPORT void RefuseContent(const std::filesystem::path& file,
                                                 const std::string& fact,
                                                 const std::string& wayOut);
} // namespace palpate
