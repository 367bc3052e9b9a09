#pragma once

#include "PalpateSessionModule.h"

#include <string>

class vtkImageData;

namespace palpate
{
/// What is wrong with a structure of so few voxels that it has no shape, as a predicate ("has only
/// ..."); empty where there are enough. `cubicMillimeters` is its volume in the mask.
PALPATESESSION_EXPORT std::string TooFewVoxels(double cubicMillimeters, vtkImageData* mask);
} // namespace palpate
