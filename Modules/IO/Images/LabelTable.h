#pragma once

#include "PalpateIOModule.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace palpate
{
/// What a table says of a label.
struct LabelEntry
{
  std::string Name;
  std::optional<std::array<double, 3>> Color; ///< red, green, blue in 0..1
};
/// By the voxels' value; never empty where a function below returns one.
using LabelTable = std::map<int, LabelEntry>;

/// A line for each label, in the format of MRIcron (`1 Precentral_L 2001`), of FreeSurfer's colour
/// tables and 3D Slicer's (`17 Left-Hippocampus 220 216 20 0`), or of ITK-SNAP
/// (`1 255 0 0 1 1 1 "Left lung"`); `#` begins a comment. None if a line is none of them.
PALPATEIO_EXPORT std::optional<LabelTable> LabelLines(const std::string& text);

/// The table in the format of ITK-SNAP's label descriptions, with the background as entry 0.
/// Labels without a colour are white; quotes in names become apostrophes.
PALPATEIO_EXPORT std::string ItkSnapTextOf(const LabelTable& table);

/// A table with a head, separated by tabs or commas: columns `index` (or `label`, `value`, `id`,
/// `key`, `labelvalue`), `name` (or `structure`, `region`, `label_name`), and if present `color`
/// (`#ff8800`, as in the *_dseg.tsv of BIDS) or `r`, `g`, `b` (0 to 255). None without the first
/// two, or if an index is no number.
PALPATEIO_EXPORT std::optional<LabelTable> LabelColumns(const std::string& text);

/// The `labels` of nnU-Net's dataset.json: `{"liver": 1}`, or `{"1": "liver"}` as before version 2.
/// Regions of several labels have no name of their own and are left out. None for anything else.
PALPATEIO_EXPORT std::optional<LabelTable> LabelsOfDataset(const std::string& json);
} // namespace palpate
