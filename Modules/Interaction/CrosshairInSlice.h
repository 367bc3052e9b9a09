#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SliceGeometry.h"
#include "SlicePosition.h"

class vtkCrosshair;
class vtkRenderer;

namespace palpate
{
/// A crosshair as a slice shows it: two lines with a gap, so that what is pointed at is seen; each
/// has the colour of the plane that it is the trace of.
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
