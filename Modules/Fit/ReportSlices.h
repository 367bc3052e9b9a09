#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// The report's slices as HTML: four axial ones, a sagittal and a coronal one through the
/// structure, true to millimetres, from the volume where there is one and from the mask otherwise,
/// with the outline of the mask's voxels and the curves of surface and model. Empty without a mask.
PALPATEFIT_EXPORT std::string ReportSlices(const FitResult& result, const Volume* volume);
} // namespace palpate
