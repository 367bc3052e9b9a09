#pragma once

#include "LabelTable.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Names and colours of the segments, by their labels.
PALPATEIO_EXPORT LabelTable LabelsOf(const Segmentation& segmentation);

/// Whether the name is that of a 3D Slicer segmentation, .seg.nrrd.
PALPATEIO_EXPORT bool IsSlicerSegmentation(const std::filesystem::path& path);

/// Whether the name is that of a label description, .txt or .label.
PALPATEIO_EXPORT bool IsLabelDescription(const std::filesystem::path& path);

/// Writes a segmentation under AtomicFile's rules by its ending. A 3D Slicer segmentation,
/// .seg.nrrd, has the layers as they are (all of one grid), with the value, name, colour, codes and
/// extent of every segment; a segment without a name is named by its label. An image of WriteImage
/// holds one layer, and names and colours if its format has a place for them (NIfTI); ITK-SNAP's
/// label description, .txt or .label, only these. Patient LPS, mm. Throws InputError.
/// Source: Slicer's documentation of the format, and slicerio's reader.
PALPATEIO_EXPORT void WriteSegmentation(const std::filesystem::path& path,
                                        const Segmentation& segmentation);
} // namespace palpate
