#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <optional>
#include <string>

namespace palpate
{
/// A kind of DICOM object that is not read.
struct ForeignDicom
{
  std::string Is;     ///< "is a DICOM dose (RTDOSE), neither a segmentation nor an image"
  std::string Remedy; ///< "use a DICOM segmentation, a label map or an image series"
};

/// Recognizes a DICOM file that holds neither a segmentation nor a slice of a volume: contours, a
/// dose, a report, an index, ...; empty for slices, segmentations and unknown objects. Throws
/// InputError for a file that is not DICOM or is damaged.
PALPATEIO_EXPORT std::optional<ForeignDicom>
RecognizeForeignDicom(const std::filesystem::path& file);

/// Throws InputError for a file that RecognizeForeignDicom recognizes.
PALPATEIO_EXPORT void RefuseForeignDicom(const std::filesystem::path& file);

/// Throws InputError for the first such file of a folder; unreadable files are skipped.
PALPATEIO_EXPORT void RefuseForeignDicomIn(const std::filesystem::path& folder);
} // namespace palpate
