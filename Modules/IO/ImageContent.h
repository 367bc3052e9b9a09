#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"
#include "Volume.h"

#include <filesystem>
#include <optional>
#include <string>

namespace palpate
{
struct ImageContent
{
  /// "NIfTI label map", "DICOM series", "3D Slicer segmentation", ...
  std::string Kind;
  std::string KindReason;      ///< why it was taken as a volume or a label map; empty if evident
  std::optional<Volume> Image; ///< absent for 3D Slicer's and DICOM segmentations
  std::optional<Segmentation> Labels; ///< absent for grey values
};

/// Reads a path as a segmentation if it states so or holds label values (see WhyNoLabelMap),
/// otherwise as a volume. Throws InputError.
PALPATEIO_EXPORT ImageContent ReadImageContent(const std::filesystem::path& path,
                                               const VolumeChoice& choice = {});
} // namespace palpate
