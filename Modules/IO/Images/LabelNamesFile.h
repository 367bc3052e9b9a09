#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Describes the segments of a label map by the files that MRIcron keeps beside it: for
/// `aal.nii.gz`, names from `aal.nii.txt` (lines "1 Precentral_L 2001") and colours from
/// `aal.nii.lut` (256 red, 256 green, 256 blue bytes). Labels without an entry keep their default.
/// A names file of another form is left alone, with a note.
PALPATEIO_EXPORT void ApplyLabelNames(Segmentation& segmentation);
} // namespace palpate
