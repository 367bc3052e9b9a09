#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"
#include "SlicePosition.h"

class vtkLandmarks;
class vtkRenderer;

namespace palpate
{
/// Landmarks in reach of a slice: the cuts of their balls with their names, and distances between
/// two that are both in reach.
class PALPATEINTERACTION_EXPORT LandmarksInSlice
{
public:
  /// Null takes them away.
  void SetRenderer(vtkRenderer* renderer);
  /// Null shows nothing.
  void Update(vtkLandmarks* landmarks, const SlicePosition& slice);

  /// How many are in reach.
  int Count() const { return this->Reached; }

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  CurveActor Marks;
  PointLabels Labels;
  int Reached = 0;
};
} // namespace palpate
