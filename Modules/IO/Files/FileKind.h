#pragma once

#include "PalpateIOModule.h"

#include <array>
#include <filesystem>
#include <vector>

namespace palpate
{
/// How the names of DICOM files end, if they end so.
inline constexpr std::array<const char*, 2> DicomEndings{{".dcm", ".ima"}};

/// Whether a file is DICOM: by its mark, whatever the name, or by its ending. Throws InputError for
/// a file that is missing, empty or not to be opened.
PALPATEIO_EXPORT bool IsDicomFile(const std::filesystem::path& file);

/// True where byte 128 starts the DICM mark.
PALPATEIO_EXPORT bool HasDicomMark(const std::filesystem::path& file);

/// The files of a folder that have the mark, sorted; what cannot be looked at, such as a link to
/// itself, is passed over. Throws InputError where the folder cannot be opened.
PALPATEIO_EXPORT std::vector<std::filesystem::path>
DicomFilesIn(const std::filesystem::path& folder);
} // namespace palpate
