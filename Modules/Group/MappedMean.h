#pragma once

#include "NormalDisplacement.h"
#include "PalpateGroupModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// A group's mean as a surface with normals (mm).
PALPATEGROUP_EXPORT vtkSmartPointer<vtkPolyData> MeanSurface(const NormalDisplacement& mean);

/// Adds a number per point. Characters that XML reserves become underscores in the name, which VTK
/// would write as they are.
PALPATEGROUP_EXPORT void AddPointMap(vtkPolyData* surface, const std::string& name,
                                     const Eigen::Ref<const Eigen::VectorXd>& values);
} // namespace palpate
