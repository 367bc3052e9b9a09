#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

namespace palpate
{
/// Makes the list of segments agree with the layers. In: layers of label values, and segments as a
/// file describes them (value, layer, name, colour; Label as the file numbers them). Out: described
/// segments without a voxel are left out, with a note; values that none describes are added without
/// a name; labels that repeat (one value in several layers) are replaced by the segments' positions
/// in the file's list, from 1; sorted by label. Throws InputError where no voxel is labelled.
PALPATEIO_EXPORT void CompleteSegments(Segmentation& segmentation);
} // namespace palpate
