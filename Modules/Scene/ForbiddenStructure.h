#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "RemovedDistances.h"
#include "Segmentation.h"
#include "ToolPose.h"
#include "ToolShape.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkImplicitPolyDataDistance;

namespace palpate
{
/// A structure that the drill must not remove: a closed surface (world mm, patient LPS).
class PALPATESCENE_EXPORT ForbiddenStructure
{
public:
  explicit ForbiddenStructure(vtkPolyData* surface);
  ForbiddenStructure(const ForbiddenStructure&) = delete;
  ForbiddenStructure& operator=(const ForbiddenStructure&) = delete;
  ~ForbiddenStructure();

  vtkPolyData* Surface() const { return this->Triangles; }

  /// Distance (mm) from a point to the surface, negative inside. One thread at a time.
  double Distance(const Vector3& pointWorld) const;
  /// The same from the nearest point of a tool.
  double Distance(const ToolShape& tool, const ToolPose& pose) const;

private:
  vtkSmartPointer<vtkPolyData> Triangles;
  vtkSmartPointer<vtkImplicitPolyDataDistance> Query;
};

/// The surface of a protected segment: all its connected components, by the default settings of
/// vtkSegmentationSurface, regardless of the settings of a fit. Throws FilterError and Cancelled.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData>
MakeForbiddenSurface(const Segmentation& segmentation, const Segment& segment,
                     const ProgressFunction& progress);

/// The protected region on the grid of a field, in the form of removed distances (see
/// DrilledField::Protect). Throws Cancelled.
PALPATESCENE_EXPORT std::shared_ptr<const RemovedDistances>
ProtectionOf(const ForbiddenStructure& structure, const RemovedDistances& like,
             const ProgressFunction& progress);

/// The union of `parts`: at least one, all on the same grid.
PALPATESCENE_EXPORT std::shared_ptr<const RemovedDistances>
JoinProtections(const std::vector<std::shared_ptr<const RemovedDistances>>& parts);
} // namespace palpate
