#pragma once

#include "PalpateFitModule.h"

#include <string>

class vtkImageData;

namespace palpate
{
struct FitResult;
struct Segment;
struct Segmentation;

/// Hint for a structure of too few voxels if no option or control chooses it.
inline constexpr const char* ChooseAnother = "choose another structure";

/// The message for a structure with too few voxels to have a shape, as a predicate ("has only
/// ..."); empty if there are enough. `cubicMillimeters` is its volume in the mask.
PALPATEFIT_EXPORT std::string TooFewVoxels(double cubicMillimeters, vtkImageData* mask);
/// The same for a structure whose every part counts, as in a field.
PALPATEFIT_EXPORT std::string TooFewVoxels(const Segmentation& segmentation,
                                           const Segment& structure);

/// The length (mm) that distances of a model are compared with: the largest side of a voxel, since
/// the mask is known no better between its slices; of a surface file, a hundredth of its size.
double ResolutionOf(const FitResult& result);

/// The highest degree that a mask's voxels support for a body of `cubicMillimeters`. On a sphere of
/// that volume and radius r, degree l has the wavelength 2 pi r / l, and wavelengths below two
/// voxels come from interpolation, not from the mask (Nyquist). A degree is the same in all
/// directions, so the largest spacing counts, usually that of slices. At least 1. Without a mask
/// (null: a surface file) 1,000, since triangles do not tell how fine a surface was measured.
PALPATEFIT_EXPORT int SupportedDegree(double cubicMillimeters, vtkImageData* mask);
} // namespace palpate
