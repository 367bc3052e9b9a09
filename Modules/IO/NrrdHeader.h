#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace palpate
{
/// The fields of an NRRD header by name: lower case without blanks ("spacedirections"), since the
/// format takes "Space Directions" and "spacedirections" as the same. Key/value pairs and comments
/// are left out. Never throws: a file that cannot be read has no fields.
PALPATEIO_EXPORT std::map<std::string, std::string>
ReadNrrdFields(const std::filesystem::path& file);

/// Looks at the header of an NRRD file before its library does, which does not say that the data
/// file of a detached header (.nhdr) is missing. Throws InputError for that; whatever else may be
/// wrong is left to the library.
/// Source: teem, Definition of NRRD File Format, https://teem.sourceforge.net/nrrd/format.html.
PALPATEIO_EXPORT void CheckNrrdHeader(const std::filesystem::path& file);

/// Throws InputError if the data of an NRRD file are shorter than the `dataBytes` of its voxels, as
/// far as their encoding says so.
PALPATEIO_EXPORT void CheckNrrdLength(const std::filesystem::path& file, double dataBytes);

/// Decodes the gzip data of an NRRD file once; throws InputError where they end early, fail their
/// checksum, which the library looks at only where the length fits, or go on far behind the
/// `dataBytes` of its voxels. Other encodings, skipped lines or bytes and several data files are
/// left to the library.
PALPATEIO_EXPORT void CheckNrrdData(const std::filesystem::path& file, std::uint64_t dataBytes);
} // namespace palpate
