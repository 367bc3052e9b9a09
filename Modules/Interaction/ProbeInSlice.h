#pragma once

#include "HaloCurve.h"
#include "HaloText.h"
#include "LengthText.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"
#include "ViewProps.h"

#include <vector>

class vtkMatrix4x4;
class vtkPolyData;
class vtkProbeRepresentation;

namespace palpate
{
/// Cross-section of a tool, placed by a rigid matrix, with a plane; world, mm.
PALPATEINTERACTION_EXPORT std::vector<SurfaceCurve> ToolSection(vtkPolyData* tool,
                                                                vtkMatrix4x4* place,
                                                                const Vector3& originWorld,
                                                                const Vector3& normalWorld);

/// A flat arrow along a vector, its head in the plane perpendicular to `normal`. Empty for a zero
/// vector.
PALPATEINTERACTION_EXPORT std::vector<SurfaceCurve>
FlatArrow(const Vector3& from, const Vector3& vector, const Vector3& normal, double headLength);

/// Whether the text of force and depth, which begins here, ends before the right edge of the view.
PALPATEINTERACTION_EXPORT bool HasRoomAtRight(const SlicePosition& slice,
                                              const Vector3& beginWorld);

/// A probe in a slice: a thin outline at the probe, a thick one at the proxy, and from there the
/// force's component in the plane; in contact also a cross at the contact point, and newtons and
/// depth at the right of the tool, or at its left if the view ends there. Nothing if the slice does
/// not cut the tool.
class PALPATEINTERACTION_EXPORT ProbeInSlice : public ViewProps
{
public:
  ProbeInSlice();

  /// Null shows nothing.
  void Update(vtkProbeRepresentation* probe, const SlicePosition& slice, LengthUnit unit);

private:
  void ShowContact(vtkProbeRepresentation* probe, const SlicePosition& slice, LengthUnit unit);

  HaloCurve Probe;
  HaloCurve Proxy;
  HaloCurve Arrow;
  HaloCurve Contact;
  vtkSmartPointer<HaloText> Text;
};
} // namespace palpate
