#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Sets names and colours of a label map's segments from the files that MRIcron stores next to it:
/// for `aal.nii.gz`, names from `aal.nii.txt` (lines "1 Precentral_L 2001") and colours from
/// `aal.nii.lut` (256 red, 256 green, 256 blue bytes). Labels without an entry keep their default.
/// A names file of another format is ignored, with a note.
PALPATEIO_EXPORT void ApplyLabelNames(Segmentation& segmentation);
} // namespace palpate
