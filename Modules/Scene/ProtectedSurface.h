#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneProduct.h"
#include "SceneSettings.h"

namespace palpate
{
/// The closed surface (world, mm) of the whole structure, regardless of the settings of a fit, made
/// from the product of its source: a segmentation, a model or a surface. Throws InputError and
/// Cancelled.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData>
ProtectedSurfaceOf(const SceneStructure& structure, const SceneProduct& source,
                   const ProgressFunction& progress);
} // namespace palpate
