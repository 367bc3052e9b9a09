#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <string>

namespace palpate
{
/// A field of an NRRD header.
struct NrrdField
{
  std::string Name;  ///< lower case without blanks, since the format takes "Space Directions" and
                     ///< "spacedirections" as the same
  std::string Value; ///< without blanks around
};

/// The field that a line of a header is; nothing for comments, key/value pairs and other lines.
PALPATEIO_EXPORT std::optional<NrrdField> ParseNrrdField(const std::string& line);

/// Reads the next line of a header, without its end; false where there is none. Keeps no more
/// than one letter beyond LongestNrrdLine, so that a longer one can be told.
constexpr std::size_t LongestNrrdLine = std::size_t{1} << 20;
PALPATEIO_EXPORT bool NextNrrdLine(std::istream& stream, std::string& line);

/// The fields of an NRRD header by name. Never throws: a file that cannot be read has no fields.
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
