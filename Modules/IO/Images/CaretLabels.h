#pragma once

#include "LabelTable.h"

namespace palpate
{
/// Code of the NIfTI header extension in which Connectome Workbench stores XML (nifti1_io.h).
/// TotalSegmentator (--ml) stores the same XML under code 0.
constexpr int CaretExtensionCode = 30;

/// The first LabelTable of a CaretExtension, as in the header of a NIfTI file. None if the text is
/// another one, declares entities, or has no label.
PALPATEIO_EXPORT std::optional<LabelTable> LabelsOfCaret(const std::string& xml);

/// The table as such a text, for one volume. Labels without a colour are white.
/// Source: Connectome Workbench, VolumeFile and GiftiLabelTable.
PALPATEIO_EXPORT std::string CaretTextOf(const LabelTable& table);
} // namespace palpate
