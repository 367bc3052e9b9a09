#pragma once

#include "FitResult.h"
#include "Progress.h"

namespace palpate
{
/// Fits a surface model to the mapped structure of `result`, draws it and judges it. `boundary` is
/// what to measure against, of a mask.
void MakeSurfaceFit(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress);
} // namespace palpate
