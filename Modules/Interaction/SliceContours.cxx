#include "SliceContours.h"

#include "ViewColors.h"
#include "vtkSurfaceDisplay.h"

#include "vtkPolyData.h"

#include <cmath>

namespace palpate
{
Eigen::AlignedBox3d SliceContours::Bounds() const
{
  Eigen::AlignedBox3d box;
  for (const Entry& contour : this->Entries)
  {
    vtkPolyData* surface = contour.Of->GetSurface();
    if (surface != nullptr && surface->GetNumberOfPoints() > 0 && !contour.Of->GetWireframe())
    {
      const double* bounds = surface->GetBounds();
      box.extend(Vector3(bounds[0], bounds[2], bounds[4]));
      box.extend(Vector3(bounds[1], bounds[3], bounds[5]));
    }
  }
  return box;
}

void SliceContours::Update(const SlicePosition& slice)
{
  for (Entry& contour : this->Entries)
  {
    this->Update(contour, slice);
  }
}

void SliceContours::Update(Entry& contour, const SlicePosition& slice)
{
  vtkSurfaceDisplay* surface = contour.Of;
  const bool isForbidden = surface->GetForbidden();
  const bool isShown = (isForbidden || surface->GetVisibility()) &&
                       surface->GetContourVisibility() && surface->GetSurface() != nullptr;
  contour.Curves->SetVisible(isShown);
  if (!isShown)
  {
    return;
  }
  const double* color = isForbidden ? ForbiddenColor.data() : surface->GetColor();
  const double width = (surface->GetHighlight() ? 2.0 : 1.0) * surface->GetLineWidth();
  contour.Curves->SetStyle({{color[0], color[1], color[2]}}, 1.0, width * slice.PointPixels);
  const Vector3& normal = slice.Frame.TowardsViewerWorld;
  const double height = normal.dot(slice.CenterWorld);
  const std::uint64_t time = surface->GetMTime();
  // A move within the plane changes its height by rounding.
  constexpr double SameHeight = 1e-9;
  const bool isSamePlane =
      std::abs(height - contour.Last.Height) < SameHeight && normal == contour.Last.Normal;
  if (time != contour.Last.Time || !isSamePlane)
  {
    contour.Curves->SetCurves(CutSurface(surface->GetSurface(), slice.CenterWorld, normal),
                              slice.Lift(ContourLayer));
    contour.Last = {time, height, normal};
    ++this->Cuts;
  }
}
} // namespace palpate
