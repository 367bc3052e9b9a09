#pragma once

#include "CurveActor.h"
#include "LengthText.h"
#include "PalpateInteractionModule.h"
#include "PointLabels.h"

#include "vtkSmartPointer.h"

class vtkProbeRepresentation;
class vtkRenderer;

namespace palpate
{
/// A line in 3D from a tool without contact to the nearest place of what is around, with its
/// length: a picture alone does not tell how deep the tool is.
class PALPATEINTERACTION_EXPORT PlumbLine
{
public:
  /// Null removes it.
  void SetRenderer(vtkRenderer* renderer);
  /// Null shows nothing.
  void Update(vtkProbeRepresentation* probe, LengthUnit unit);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  CurveActor Line;
  PointLabels Length;
};
} // namespace palpate
