#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

namespace palpate
{
class ReportPage;

/// Adds the report's slices: four axial ones, a sagittal and a coronal one through the
/// structure, to scale, of the volume if there is one and otherwise of the mask, with the outline
/// of the mask's voxels and the curves of surface and model. Of a surface file, which has no mask,
/// of the volume or of what is inside. Nothing without either.
PALPATEFIT_EXPORT void ReportSlices(ReportPage& page, const FitResult& result,
                                    const Volume* volume);
/// The same, axial, through the places that the repair of a surface model's structure changed most
/// and that its surface leaves out, with a ring round each. Nothing if there are none.
PALPATEFIT_EXPORT void ReportRepair(ReportPage& page, const FitResult& result,
                                    const Volume* volume);
} // namespace palpate
