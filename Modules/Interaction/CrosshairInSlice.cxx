#include "CrosshairInSlice.h"

#include "vtkCrosshair.h"

#include "vtkActor.h"

namespace palpate
{
namespace
{
constexpr double CenterGap = 8.0; // points from the centre to the lines
constexpr double CrosshairWidth = 1.0;
} // namespace

CrosshairInSlice::CrosshairInSlice()
{
  this->Add(this->Across.Actor());
  this->Add(this->Up.Actor());
}

void CrosshairInSlice::Update(vtkCrosshair* crosshair, SliceOrientation orientation,
                              const SlicePosition& slice)
{
  const bool isShown = crosshair != nullptr && crosshair->GetVisibility();
  this->SetVisible(isShown);
  if (!isShown)
  {
    return;
  }
  const Vector3 middle = slice.Projected(Vector3(crosshair->GetPositionWorld()));
  const double gap = CenterGap * slice.PointPixels * slice.PixelMillimeters;
  const double reach =
      (middle - slice.CenterWorld).norm() + slice.PixelMillimeters * (slice.Width + slice.Height);
  const auto lines = [&](const Vector3& along)
  {
    return std::vector<SurfaceCurve>{{{middle - reach * along, middle - gap * along}, false},
                                     {{middle + gap * along, middle + reach * along}, false}};
  };
  const bool isAxial = orientation == SliceOrientation::Axial;
  const bool isSagittal = orientation == SliceOrientation::Sagittal;
  this->Across.SetCurves(lines(slice.Frame.RightWorld), slice.Lift(CrosshairLayer));
  this->Across.SetStyle(ColorOf(isAxial ? SliceOrientation::Coronal : SliceOrientation::Axial), 1.0,
                        CrosshairWidth * slice.PointPixels);
  this->Up.SetCurves(lines(slice.Frame.UpWorld), slice.Lift(CrosshairLayer));
  this->Up.SetStyle(ColorOf(isSagittal ? SliceOrientation::Coronal : SliceOrientation::Sagittal),
                    1.0, CrosshairWidth * slice.PointPixels);
}
} // namespace palpate
