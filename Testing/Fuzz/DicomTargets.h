#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// DICOM slices, series and segmentations, with pixels as they are and in every compression.
std::vector<FuzzTarget> DicomTargets();
} // namespace palpate::test
