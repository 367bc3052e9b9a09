#pragma once

#include "PalpateFitModule.h"

class vtkImageData;

namespace palpate
{
/// The highest degree that a mask's voxels support for a body of `cubicMillimeters`. On a sphere of
/// that volume and radius r, degree l has the wavelength 2 pi r / l, and wavelengths below two
/// voxels come from interpolation, not from the mask (Nyquist). A degree is the same in all
/// directions, so the largest spacing counts, usually that of slices. At least 1.
PALPATEFIT_EXPORT int SupportedDegree(double cubicMillimeters, vtkImageData* mask);
} // namespace palpate
