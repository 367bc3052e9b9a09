#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"

#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

class vtkLandmarks;
class vtkRenderer;

namespace palpate
{
/// Landmarks as spheres with their names, curves as lines within thin tubes, which are seen also
/// where a curve lies in a surface.
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
  CurveActor Lines;
  vtkNew<vtkTubeFilter> Tube;
  vtkNew<vtkActor> Tubes;
  PointLabels Labels;
};
} // namespace palpate
