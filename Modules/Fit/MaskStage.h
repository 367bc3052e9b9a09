#pragma once

#include "FitStages.h"

namespace palpate
{
/// The surface of a mask's component that is fitted, and the half-level surface to measure against.
void RunMaskSurface(FitSurface& made, const ProgressFunction& progress);

/// The half-level surface of a component of the mask (0: of all of it).
vtkSmartPointer<vtkPolyData> BoundaryOf(const FitResult& result, int component,
                                        const ProgressFunction& progress);
} // namespace palpate
