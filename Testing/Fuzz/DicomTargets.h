#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// DICOM slices, series, segmentations and structure sets, uncompressed and in every supported
/// compression.
std::vector<FuzzTarget> DicomTargets();
} // namespace palpate::test
