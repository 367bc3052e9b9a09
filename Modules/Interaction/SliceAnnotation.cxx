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

// "Axial  91 / 181".
std::string TitleOf(SliceOrientation orientation, const SliceGeometry& geometry,
                    const Vector3& placeWorld)
{
  std::string text = NameOf(orientation);
  if (geometry.HasNumbers())
  {
    text += "  " + std::to_string(geometry.NumberOf(placeWorld) + 1) + " / " +
            std::to_string(geometry.Count);
  }
  return text;
}

// "S 19.0 mm".
std::string PlaceOf(const SliceGeometry& geometry, const Vector3& placeWorld, LengthUnit unit)
{
  const double place = placeWorld.dot(geometry.ForwardWorld);
  const Vector3 side = place < 0.0 ? Vector3(-geometry.ForwardWorld) : geometry.ForwardWorld;
  return OrientationLetters(side) + " " + LengthText(unit, std::abs(place), 1);
}
} // namespace

SliceAnnotation::SliceAnnotation() : Text(MakeViewText(0.015, 0.985, AnnotationTextSize))
{
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
  const auto lighter = [&color](std::size_t part) { return 0.55 * color[part] + 0.45; };
  this->Text->GetTextProperty()->SetColor(lighter(0), lighter(1), lighter(2));
  const std::string title =
      this->IsTitled ? TitleOf(orientation, geometry, placeWorld) + "\n" : std::string();
  SetViewText(this->Text, title + PlaceOf(geometry, placeWorld, unit));
}
} // namespace palpate
