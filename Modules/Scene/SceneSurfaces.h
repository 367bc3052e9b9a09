#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneSettings.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace palpate
{
/// The surfaces (mm, patient LPS) of the visible structures of a scene with resolved labels, in its
/// order: of the model if one is felt, else of the voxels or the file. Throws InputError,
/// FilterError and Cancelled.
PALPATESCENE_EXPORT std::vector<vtkSmartPointer<vtkPolyData>>
DisplayedSurfaces(const SceneSettings& scene, const ProgressFunction& progress);
} // namespace palpate
