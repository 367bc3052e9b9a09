#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SliceGeometry.h"
#include "SlicePosition.h"

class vtkCrosshair;
class vtkRenderer;

namespace palpate
{
/// A crosshair in a slice: two lines with a gap, so that the point itself is visible; each has the
/// colour of the plane whose trace it is.
class PALPATEINTERACTION_EXPORT CrosshairInSlice
{
public:
  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  /// Null shows nothing.
  void Update(vtkCrosshair* crosshair, SliceOrientation orientation, const SlicePosition& slice);

private:
  CurveActor Across; // from left to right
  CurveActor Up;
};
} // namespace palpate
