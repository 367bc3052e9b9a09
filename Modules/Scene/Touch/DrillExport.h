#pragma once

#include "DrillContext.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// The current state of a drilled structure, for WriteImage and WriteSurface. The functions throw
/// Cancelled and FilterError.

/// The image or label map that it was made from, on the same grid and of the same type: image
/// samples as if the drilled structure had been scanned; in a label map, voxels whose centres were
/// removed lose the label.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData>
DrilledImage(const DrillContext& context, int site, const ProgressFunction& progress);

/// The closed surface as it is touched, in world mm (patient LPS).
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData>
DrilledSurface(const DrillContext& context, int site, const ProgressFunction& progress);

/// The closed surface of the removed volume, in world mm; may be empty. Takes milliseconds.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData> RemovedSurface(const DrillContext& context,
                                                                int site);
} // namespace palpate
