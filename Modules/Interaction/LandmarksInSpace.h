#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"

#include "vtkActor.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

class vtkAlgorithmOutput;
class vtkLandmarks;
class vtkRenderer;

namespace palpate
{
/// Landmarks as spheres with their names, curves as lines within thin tubes, which are seen also
/// where a curve lies in a surface. Spheres and tubes have dark rims. Where something hides them,
/// they and their texts are faint.
class PALPATEINTERACTION_EXPORT LandmarksInSpace
{
public:
  LandmarksInSpace();

  /// Null removes them.
  void SetRenderer(vtkRenderer* renderer);
  /// Null shows nothing.
  void Update(vtkLandmarks* landmarks);

private:
  // The geometry, its rim, and what shows through.
  struct Solid
  {
    vtkNew<vtkActor> Body;
    vtkNew<vtkActor> Rim;
    vtkNew<vtkActor> Ghost;
  };
  static void Make(Solid& solid, vtkAlgorithmOutput* body, vtkAlgorithmOutput* rim);
  static void Show(Solid& solid, bool isShown, const double* color);

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkPolyData> Places;
  // Of the last update.
  vtkLandmarks* Shown = nullptr;
  static constexpr vtkMTimeType Never = ~vtkMTimeType{0};
  vtkMTimeType Time = Never;
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkSphereSource> LargerSphere;
  Solid Spheres;
  CurveActor Lines;
  vtkNew<vtkTubeFilter> Tube;
  vtkNew<vtkTubeFilter> WiderTube;
  Solid Tubes;
  PointLabels Labels;
};
} // namespace palpate
