#pragma once

#include "PalpateIOModule.h"

#include <array>
#include <filesystem>
#include <vector>

namespace palpate
{
/// Endings of DICOM files, which may also have none.
inline constexpr std::array<const char*, 2> DicomEndings{{".dcm", ".ima"}};

/// Whether a file is DICOM: by its mark, whatever its name, or by its ending. Throws InputError for
/// a file that is missing, empty or cannot be opened.
PALPATEIO_EXPORT bool IsDicomFile(const std::filesystem::path& file);

/// Whether the DICM mark is at byte 128.
PALPATEIO_EXPORT bool HasDicomMark(const std::filesystem::path& file);

/// The files of a folder that have the mark, sorted; inaccessible entries, such as a link to
/// itself, are skipped. Throws InputError if the folder cannot be opened.
PALPATEIO_EXPORT std::vector<std::filesystem::path>
DicomFilesIn(const std::filesystem::path& folder);
} // namespace palpate
