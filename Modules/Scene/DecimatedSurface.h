#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// A closed surface by about so many triangles, fewer than it has, its volume kept. Throws
/// FilterError and Cancelled.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData> DecimatedSurface(vtkPolyData* surface, int facets,
                                                                  const ProgressFunction& progress);
} // namespace palpate
