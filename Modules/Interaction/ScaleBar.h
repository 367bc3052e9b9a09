#pragma once

#include "LengthText.h"
#include "PalpateInteractionModule.h"
#include "ViewProps.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

class vtkTextActor;

namespace palpate
{
/// A bar of a round length at the lower left of a view, with the length as text.
class PALPATEINTERACTION_EXPORT ScaleBar : public ViewProps
{
public:
  ScaleBar();

  /// The largest 1, 2 or 5 times a power of ten that does not exceed `millimeters` > 0.
  static double RoundLength(double millimeters);

  /// For a view of that many pixels, with `pointPixels` pixels per point (1/72 inch).
  void Update(double pixelMillimeters, int width, int height, double pointPixels,
              LengthUnit unit = LengthUnit::Millimeter);

  double LengthMillimeters() const { return this->Length; }

private:
  double Length = 0.0;
  vtkNew<vtkPolyData> Line;
  vtkNew<vtkActor2D> Bar;
  vtkSmartPointer<vtkTextActor> Label;
};
} // namespace palpate
