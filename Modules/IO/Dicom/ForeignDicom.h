#pragma once

#include "ForeignFile.h"

namespace palpate
{
/// What a DICOM file is that holds neither a segmentation nor a slice of a volume: contours, a
/// dose, a report, an index, ...; nothing for slices, segmentations and what is not known. Throws
/// InputError for a file that is not DICOM or is damaged.
PALPATEIO_EXPORT std::optional<ForeignFile>
RecognizeForeignDicom(const std::filesystem::path& file);

/// Throws InputError for a file that RecognizeForeignDicom knows.
PALPATEIO_EXPORT void RefuseForeignDicom(const std::filesystem::path& file);

/// Throws InputError for the first such file of a folder; files that cannot be read are passed
/// over.
PALPATEIO_EXPORT void RefuseForeignDicomIn(const std::filesystem::path& folder);
} // namespace palpate
