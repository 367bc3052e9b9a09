#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <optional>
#include <string>

namespace palpate
{
/// A file of a format that Palpate recognizes but does not read.
struct ForeignFile
{
  std::string Is;     ///< "is a legacy VTK file (POLYDATA), a surface"
  std::string Remedy; ///< "save it as .vtp"
};

/// Recognizes a file by its first bytes (decompressed if it is a gzip file), otherwise by the
/// ending of its name; empty for an unknown file. Reads at most 512 bytes of its content.
PALPATEIO_EXPORT std::optional<ForeignFile> RecognizeForeignFile(const std::filesystem::path& file);

/// Throws InputError with the file's recognized format; if it is unknown, with this fact and fix.
[[noreturn]] PALPATEIO_EXPORT void RefuseContent(const std::filesystem::path& file,
                                                 const std::string& fact,
                                                 const std::string& remedy);
} // namespace palpate
