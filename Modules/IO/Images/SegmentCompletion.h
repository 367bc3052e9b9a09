#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

namespace palpate
{
/// Makes the list of segments agree with the layers. Input: layers of label values, and segments as
/// a file describes them (value, layer, name, colour; Label by the file's numbering). Output:
/// described segments without a voxel are removed, with a note; undescribed values are added
/// without a name; duplicate labels (one value in several layers) are replaced by the segments'
/// positions in the file's list, from 1; sorted by label. Throws InputError if no voxel is
/// labelled.
PALPATEIO_EXPORT void CompleteSegments(Segmentation& segmentation);
} // namespace palpate
