#pragma once

#include "ForeignFile.h"

namespace palpate
{
/// Recognizes a DICOM file that holds neither a segmentation nor a slice of a volume: contours, a
/// dose, a report, an index, ...; empty for slices, segmentations and unknown objects. Throws
/// InputError for a file that is not DICOM or is damaged.
PALPATEIO_EXPORT std::optional<ForeignFile>
RecognizeForeignDicom(const std::filesystem::path& file);

/// Throws InputError for a file that RecognizeForeignDicom recognizes.
PALPATEIO_EXPORT void RefuseForeignDicom(const std::filesystem::path& file);

/// Throws InputError for the first such file of a folder; unreadable files are skipped.
PALPATEIO_EXPORT void RefuseForeignDicomIn(const std::filesystem::path& folder);
} // namespace palpate
