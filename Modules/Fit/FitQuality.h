#pragma once

#include "FitResult.h"
#include "Progress.h"

namespace palpate
{
/// Two-sided distances of the drawn model, the fitted surface and the mask's half-level boundary
/// from each other; of a surface file those of the model only. Reports progress in the part [0.3,
/// 1]; throws Cancelled and FilterError.
void MeasureQuality(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress);
} // namespace palpate
