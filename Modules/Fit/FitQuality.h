#pragma once

#include "FitResult.h"
#include "Progress.h"

namespace palpate
{
/// Overlap of the drawn model with the mask on the mask's own grid.
void MeasureOverlap(FitResult& result);

/// Two-sided distances of the drawn model, the fitted surface and the mask's half-level boundary
/// from each other. Reports progress in the part [0.3, 1]; throws Cancelled and FilterError.
void MeasureDistances(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress);
} // namespace palpate
