#pragma once

#include "PalpateIOModule.h"

class vtkImageData;
class vtkInformation;

namespace palpate
{
/// Tells a pipeline what a reader will give: extent, spacing, origin, direction, scalar type. VTK
/// 9.1 passes all of these downstream but the direction.
PALPATEIO_EXPORT void DescribeOutput(vtkImageData* image, vtkInformation* output);
} // namespace palpate
