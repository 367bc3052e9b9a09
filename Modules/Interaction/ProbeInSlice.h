#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"

#include <vector>

class vtkMatrix4x4;
class vtkPolyData;
class vtkProbeRepresentation;
class vtkRenderer;

namespace palpate
{
/// Where a tool that was placed by a rigid matrix cuts a plane; world, mm.
PALPATEINTERACTION_EXPORT std::vector<SurfaceCurve> CutTool(vtkPolyData* tool, vtkMatrix4x4* place,
                                                            const Vector3& originWorld,
                                                            const Vector3& normalWorld);

/// A flat arrow along a vector, its head in the plane across `normal`. Empty for a vector without
/// length.
PALPATEINTERACTION_EXPORT std::vector<SurfaceCurve>
FlatArrow(const Vector3& from, const Vector3& vector, const Vector3& normal, double headLength);

/// A probe as a slice shows it: thin where the device is, strong where the tool is drawn, and the
/// force's part in the plane from there. Nothing of a tool that the slice does not cut.
class PALPATEINTERACTION_EXPORT ProbeInSlice
{
public:
  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  /// Null shows nothing.
  void Update(vtkProbeRepresentation* probe, const SlicePosition& slice);

private:
  CurveActor Probe;
  CurveActor Proxy;
  CurveActor Arrow;
};
} // namespace palpate
