#pragma once

#include "PalpateFitModule.h"

class vtkImageData;

namespace palpate
{
/// The highest degree whose shape a mask can tell of a body of `cubicMillimeters`. Waves of degree
/// l are 2 pi r / l long round a ball of that volume, and what is shorter than two voxels is not in
/// the mask but in how it was interpolated (Nyquist). A degree is the same in all directions, so
/// the largest spacing counts, mostly that of slices. At least 1.
PALPATEFIT_EXPORT int SupportedDegree(double cubicMillimeters, vtkImageData* mask);
} // namespace palpate
