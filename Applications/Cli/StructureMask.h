#pragma once

#include "Segmentation.h"

namespace palpate::cli
{
/// One structure as a mask of 0 and 1 on its layer's grid (unsigned char).
vtkSmartPointer<vtkImageData> MaskOf(const Segmentation& segmentation, const Segment& structure);
} // namespace palpate::cli
