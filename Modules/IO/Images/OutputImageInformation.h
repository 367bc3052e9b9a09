#pragma once

#include "PalpateIOModule.h"

class vtkImageData;
class vtkInformation;

namespace palpate
{
/// Sets the output information of a reader: extent, spacing, origin, direction, scalar type. VTK
/// 9.1 passes all of these downstream except the direction.
PALPATEIO_EXPORT void DescribeOutput(vtkImageData* image, vtkInformation* output);
} // namespace palpate
