#pragma once

#include "CurveActor.h"
#include "LengthText.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkProbeRepresentation;
class vtkRenderer;

namespace palpate
{
/// "1.20 N, 3.4 mm deep": the force of a tool in contact, and how far it is from its proxy.
PALPATEINTERACTION_EXPORT std::string PressText(vtkProbeRepresentation* probe, LengthUnit unit);

/// What a hand would feel, beside the tool in 3D: without contact a line to the nearest place of
/// what is around, with its length, since an image alone does not tell how deep the tool is; in
/// contact a bar of the force, with newtons and depth.
class PALPATEINTERACTION_EXPORT PlumbLine
{
public:
  /// Null removes it.
  void SetRenderer(vtkRenderer* renderer);
  /// Null shows nothing.
  void Update(vtkProbeRepresentation* probe, LengthUnit unit);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  void ShowForce(vtkProbeRepresentation* probe, LengthUnit unit);

  CurveActor Line;
  CurveActor Bar; // of the force
  PointLabels Length;
};
} // namespace palpate
