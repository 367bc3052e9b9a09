#pragma once

#include "HaloCurve.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"
#include "SlicePosition.h"

class vtkLandmarks;
class vtkRenderer;

namespace palpate
{
/// Landmarks within reach of a slice: cross-sections of their spheres with their names, and the
/// parts of curves within reach with their labels.
class PALPATEINTERACTION_EXPORT LandmarksInSlice
{
public:
  /// Null removes them.
  void SetRenderer(vtkRenderer* renderer);
  /// Null shows nothing.
  void Update(vtkLandmarks* landmarks, const SlicePosition& slice);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  HaloCurve Marks;
  PointLabels Labels;
};
} // namespace palpate
