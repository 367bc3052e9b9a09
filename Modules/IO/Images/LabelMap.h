#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"
#include "Volume.h"

namespace palpate
{
/// The label map that a volume holds: its own image where that has a label type, else a copy in the
/// smallest one. Names and colours come from files beside the volume's source (LabelNamesFile).
/// Throws InputError for values that are no labels and where no voxel is labelled.
PALPATEIO_EXPORT Segmentation LabelMapOf(const Volume& volume);

/// Why a volume is grey values and no label map, as a phrase; empty where it is one. A label map
/// has whole, not negative values, at most 1,024 different ones; with more than 16 it must also be
/// piecewise constant: of the pairs of voxels side by side along the first axis of which one at
/// least is not 0, at least 40 % are equal. (Measured on MRIcron's files: atlases of the brain have
/// 57 to 91 %, 8-bit MR heads 9 to 23 %.)
PALPATEIO_EXPORT std::string WhyNoLabelMap(const Volume& volume);
} // namespace palpate
