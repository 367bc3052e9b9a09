#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"

#include "vtkSphereSource.h"

class vtkLandmarks;
class vtkRenderer;

namespace palpate
{
/// Landmarks as spheres with their names, distances as lines.
class PALPATEINTERACTION_EXPORT LandmarksInSpace
{
public:
  LandmarksInSpace();

  /// Null removes them.
  void SetRenderer(vtkRenderer* renderer);
  /// Null shows nothing.
  void Update(vtkLandmarks* landmarks);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkPolyData> Places;
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkActor> Spheres;
  CurveActor Distances;
  PointLabels Labels;
};
} // namespace palpate
