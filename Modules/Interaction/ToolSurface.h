#pragma once

#include "PalpateInteractionModule.h"
#include "ToolShape.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// A tool's shape as a closed surface to draw, in the tool's own frame, mm: its sphere, or the
/// convex hull of its shell. A point is a sphere of 0.5 mm, so that it is visible.
PALPATEINTERACTION_EXPORT vtkSmartPointer<vtkPolyData> MakeToolSurface(const ToolShape& tool);

/// The sphere that draws a tool of that radius.
PALPATEINTERACTION_EXPORT vtkSmartPointer<vtkPolyData> MakeToolSphere(double radius);
} // namespace palpate
