#pragma once

#include "DrillBench.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// What is left of a drilled structure, as it is now, to be written by WriteImage and WriteSurface.
/// Throw Cancelled and FilterError.

/// The image or the label map that it was made from, on the same grid and of the same type: the
/// image's samples as if it had been scanned like that; of the label map those voxels without the
/// label whose centres are gone.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData> DrilledImage(const DrillBench& bench, int site,
                                                               const ProgressFunction& progress);

/// The closed surface, as the hand feels it, in world mm (patient LPS).
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData> DrilledSurface(const DrillBench& bench, int site,
                                                                const ProgressFunction& progress);

/// The closed surface of what is gone, in world mm; empty where nothing is. Takes milliseconds.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData> RemovedSurface(const DrillBench& bench, int site);
} // namespace palpate
