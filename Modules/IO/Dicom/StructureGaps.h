#pragma once

#include "PalpateIOModule.h"
#include "SegmentLayers.h"
#include "Segmentation.h"

#include <string>
#include <vector>

namespace palpate
{
/// A note on slices without voxels between the first and the last slice of a structure, with their
/// places: a DICOM file leaves out frames and contours of empty slices, so that a missing one does
/// not show otherwise. Empty if there are none.
PALPATEIO_EXPORT std::string GapNote(const Segment& structure, const ImageGrid& grid,
                                     const std::vector<VoxelRun>& runs);
} // namespace palpate
