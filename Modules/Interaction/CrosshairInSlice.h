#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SliceGeometry.h"
#include "SlicePosition.h"
#include "ViewProps.h"

class vtkCrosshair;

namespace palpate
{
/// A crosshair in a slice: two lines with a gap, so that the point itself is visible; each has the
/// colour of the plane whose trace it is.
class PALPATEINTERACTION_EXPORT CrosshairInSlice : public ViewProps
{
public:
  CrosshairInSlice();

  /// Null shows nothing.
  void Update(vtkCrosshair* crosshair, SliceOrientation orientation, const SlicePosition& slice);

private:
  CurveActor Across; // from left to right
  CurveActor Up;
};
} // namespace palpate
