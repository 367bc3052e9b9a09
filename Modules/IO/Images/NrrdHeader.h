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
struct NrrdField
{
  std::string Name;  ///< lower case without spaces, since the format treats "Space Directions" and
                     ///< "spacedirections" as the same
  std::string Value; ///< without surrounding white space
};

/// Parses a header line as a field; empty for comments, key/value pairs and other lines.
PALPATEIO_EXPORT std::optional<NrrdField> ParseNrrdField(const std::string& line);

/// Reads the next line of a header, without its line end; returns false if there is none. Keeps at
/// most one character beyond LongestNrrdLine, so that longer lines can be detected.
constexpr std::size_t LongestNrrdLine = std::size_t{1} << 20;
PALPATEIO_EXPORT bool NextNrrdLine(std::istream& stream, std::string& line);

/// The fields of an NRRD header by name. Never throws: a file that cannot be read has no fields.
PALPATEIO_EXPORT std::map<std::string, std::string>
ReadNrrdFields(const std::filesystem::path& file);

/// Checks the header of an NRRD file before its library reads it. Throws InputError for what the
/// library refuses without a cause: a missing data file of a detached header (.nhdr), bzip2, which
/// Debian builds the library without, and an axis without a direction or a kind. Other errors are
/// left to the library.
/// Source: teem, Definition of NRRD File Format, https://teem.sourceforge.net/nrrd/format.html.
PALPATEIO_EXPORT void CheckNrrdHeader(const std::filesystem::path& file);

/// Throws InputError if the data of an NRRD file are shorter than the `dataBytes` of its voxels, as
/// far as their encoding shows this.
PALPATEIO_EXPORT void CheckNrrdLength(const std::filesystem::path& file, double dataBytes);

/// Decodes the gzip data of an NRRD file once; throws InputError if they end early, fail their
/// checksum, which the library checks only if the length is right, or continue far beyond the
/// `dataBytes` of its voxels. Other encodings, skipped lines or bytes and several data files are
/// left to the library.
PALPATEIO_EXPORT void CheckNrrdData(const std::filesystem::path& file, std::uint64_t dataBytes);
} // namespace palpate
