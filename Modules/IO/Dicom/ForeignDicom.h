#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <optional>
#include <string>

namespace palpate
{
struct ForeignDicom
{
  std::string Is;     ///< "is a multi-frame DICOM image (RTDoseStorage), which is not supported"
  std::string Remedy; ///< "convert it to one slice per file or to NIfTI-1 (.nii.gz)"
};

/// Recognizes a DICOM file that is no segmentation or structure set and has several frames or no
/// pixels: surfaces, a dose, a report, an index, ... Throws InputError for a file that is not DICOM
/// or is damaged.
PALPATEIO_EXPORT std::optional<ForeignDicom>
RecognizeForeignDicom(const std::filesystem::path& file);

/// Throws InputError for a file that RecognizeForeignDicom recognizes.
PALPATEIO_EXPORT void RefuseForeignDicom(const std::filesystem::path& file);

/// Throws InputError for the first such file of a folder; unreadable files are skipped.
PALPATEIO_EXPORT void RefuseForeignDicomIn(const std::filesystem::path& folder);
} // namespace palpate
