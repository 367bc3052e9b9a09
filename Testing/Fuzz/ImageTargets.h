#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// NIfTI, Analyze, FreeSurfer, GIPL, NRRD, 3D Slicer's segmentations, MetaImage, and MRIcron's
/// names and colours.
std::vector<FuzzTarget> ImageTargets();
} // namespace palpate::test
