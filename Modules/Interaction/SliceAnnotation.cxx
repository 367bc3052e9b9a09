#include "SliceAnnotation.h"

#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cmath>
#include <string>

namespace palpate
{
namespace
{
constexpr int AnnotationTextSize = 11; // points

// "Axial  91 / 181" and, below, "S 19.0 mm".
std::string Describe(SliceOrientation orientation, const SliceGeometry& geometry,
                     const Vector3& placeWorld, LengthUnit unit)
{
  std::string text = NameOf(orientation);
  if (geometry.HasNumbers())
  {
    text += "  " + std::to_string(geometry.NumberOf(placeWorld) + 1) + " / " +
            std::to_string(geometry.Count);
  }
  const double place = placeWorld.dot(geometry.ForwardWorld);
  const Vector3 side = place < 0.0 ? Vector3(-geometry.ForwardWorld) : geometry.ForwardWorld;
  return text + "\n" + OrientationLetters(side) + " " + LengthText(unit, std::abs(place), 1);
}
} // namespace

SliceAnnotation::SliceAnnotation() : Text(MakeViewText(0.015, 0.985, AnnotationTextSize))
{
  vtkTextProperty* style = this->Text->GetTextProperty();
  style->ShadowOff(); // VTK would draw a white one under such colours
  style->SetBackgroundColor(0.0, 0.0, 0.0);
  style->SetBackgroundOpacity(0.5);
  this->Add(this->Letters);
  this->Add(this->Bar);
  this->Add(this->Text);
}

void SliceAnnotation::Update(SliceOrientation orientation, const SliceGeometry& geometry,
                             const SlicePosition& slice, const Vector3& placeWorld, LengthUnit unit)
{
  this->Letters.Update(slice.Frame);
  this->Bar.Update(slice.PixelMillimeters, slice.Width, slice.Height, slice.PointPixels, unit);
  const std::array<double, 3> color = ColorOf(orientation);
  this->Text->GetTextProperty()->SetColor(color[0], color[1], color[2]);
  SetViewText(this->Text, Describe(orientation, geometry, placeWorld, unit));
}
} // namespace palpate
