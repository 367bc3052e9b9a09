#pragma once

#include "LabelTable.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// Files that may have names of a label map's labels, in the order in which they are tried. For
/// `DIR/a.nii.gz`: `a.nii.txt` (MRIcron); `a.label`, `a.lbl`, `a.label.txt`, `a.txt`, `a.ctab` and
/// `a.ctbl` (ITK-SNAP, FreeSurfer, 3D Slicer); `a.label.tsv`, `a.label.csv`, `a.tsv` and `a.csv`
/// (BIDS, and others with a head); `FreeSurferColorLUT.txt` and nnU-Net's `dataset.json` in DIR,
/// and the latter in the folder above.
PALPATEIO_EXPORT std::vector<std::filesystem::path>
LabelTablesOf(const std::filesystem::path& image);

/// Sets names and colours of a label map's segments from the first of these files that is such a
/// table (LabelTable) and knows one of the labels, with a note; and colours from MRIcron's
/// `a.nii.lut` (256 red, 256 green, 256 blue bytes). `own` is the image's own table, which counts
/// less than files named after the image, and more than those for a whole folder. Labels without an
/// entry keep their default.
PALPATEIO_EXPORT void ApplyLabelNames(Segmentation& segmentation, const LabelTable& own = {});
} // namespace palpate
