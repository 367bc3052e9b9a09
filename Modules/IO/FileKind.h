#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// Formats of image files that can be read.
enum class FileKind
{
  Nifti,     ///< .nii, .nii.gz
  Nrrd,      ///< .nrrd, .nhdr
  MetaImage, ///< .mha, .mhd
  Dicom      ///< the DICM mark, whatever the name; or .dcm, .ima
};

/// The kind of a file: DICOM by its mark, the others by the end of their names. Throws InputError
/// for a file that is missing, empty, not to be opened, or of no known kind.
PALPATEIO_EXPORT FileKind DetectFileKind(const std::filesystem::path& file);

/// "NIfTI", "NRRD", "MetaImage" or "DICOM".
PALPATEIO_EXPORT const char* FileKindName(FileKind kind);

/// True where byte 128 starts the DICM mark.
PALPATEIO_EXPORT bool HasDicomMark(const std::filesystem::path& file);

/// The files of a folder that have the mark, sorted; what cannot be looked at, such as a link to
/// itself, is passed over. Throws InputError where the folder cannot be opened.
PALPATEIO_EXPORT std::vector<std::filesystem::path>
DicomFilesIn(const std::filesystem::path& folder);
} // namespace palpate
