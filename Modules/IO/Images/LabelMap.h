#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"
#include "Volume.h"

namespace palpate
{
/// Converts a volume to a label map: shares its image if that has a label type, otherwise copies it
/// to the smallest one. Names and colours come from the file or from files next
/// to it (LabelNamesFile). Throws InputError for values that are not labels, and if no voxel is
/// labelled.
PALPATEIO_EXPORT Segmentation LabelMapOf(const Volume& volume);

/// Why a volume is greyscale and not a label map, as a phrase; empty if it is a label map. A label
/// map has whole, non-negative values, at most 1,024 different ones; with more than 16 it must also
/// be piecewise constant: of the voxel pairs adjacent along the first axis with at least one voxel
/// not 0, at least 40 % are equal. (Measured on MRIcron's files: atlases of the brain have 57 to 91
/// %, 8-bit MR heads 9 to 23 %.)
PALPATEIO_EXPORT std::string WhyNoLabelMap(const Volume& volume);
} // namespace palpate
