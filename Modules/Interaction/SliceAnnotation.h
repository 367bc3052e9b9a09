#pragma once

#include "PalpateInteractionModule.h"
#include "ScaleBar.h"
#include "SliceGeometry.h"
#include "SlicePosition.h"
#include "ViewText.h"

namespace palpate
{
/// Text over a slice: letters of the patient's directions, a scale bar, and the slice's number and
/// position, in the colour of its plane.
class PALPATEINTERACTION_EXPORT SliceAnnotation : public ViewProps
{
public:
  SliceAnnotation();
  /// Whether the plane's name and the slice's number are part of the text; on by default.
  void SetTitled(bool isTitled) { this->IsTitled = isTitled; }
  /// `placeWorld` is a point of the slice.
  void Update(SliceOrientation orientation, const SliceGeometry& geometry,
              const SlicePosition& slice, const Vector3& placeWorld, LengthUnit unit);

private:
  EdgeLetters Letters;
  ScaleBar Bar;
  bool IsTitled = true;
  vtkSmartPointer<HaloText> Text;
};
} // namespace palpate
