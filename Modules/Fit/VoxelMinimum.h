#pragma once

#include "PalpateFitModule.h"

#include <string>

class vtkImageData;

namespace palpate
{
struct Segment;
struct Segmentation;

/// What to do about a structure of too few voxels, where no option or control chooses it.
inline constexpr const char* ChooseAnother = "choose another structure";

/// What is wrong with a structure of so few voxels that it has no shape, as a predicate ("has only
/// ..."); empty where there are enough. `cubicMillimeters` is its volume in the mask.
PALPATEFIT_EXPORT std::string TooFewVoxels(double cubicMillimeters, vtkImageData* mask);
/// The same of a structure whose every part counts, as in a field; where all of them are too few,
/// it tells of the largest.
PALPATEFIT_EXPORT std::string TooFewVoxels(const Segmentation& segmentation,
                                           const Segment& structure);
} // namespace palpate
