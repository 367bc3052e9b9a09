#include "SliceContours.h"

#include "ViewColors.h"
#include "vtkSurfaceDisplay.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
void SliceContours::SetRenderer(vtkRenderer* renderer)
{
  for (const Contour& contour : this->Contours)
  {
    if (this->Renderer != nullptr)
    {
      this->Renderer->RemoveViewProp(contour.Curves->Actor());
    }
    if (renderer != nullptr)
    {
      renderer->AddViewProp(contour.Curves->Actor());
    }
  }
  this->Renderer = renderer;
}

void SliceContours::Add(vtkSurfaceDisplay* surface)
{
  Contour contour;
  contour.Surface = surface;
  contour.Curves = std::make_unique<CurveActor>();
  if (this->Renderer != nullptr)
  {
    this->Renderer->AddViewProp(contour.Curves->Actor());
  }
  this->Contours.push_back(std::move(contour));
}

void SliceContours::Remove(vtkSurfaceDisplay* surface)
{
  const auto isGone = [surface](const Contour& contour) { return contour.Surface == surface; };
  for (const Contour& contour : this->Contours)
  {
    if (this->Renderer != nullptr && isGone(contour))
    {
      this->Renderer->RemoveViewProp(contour.Curves->Actor());
    }
  }
  this->Contours.erase(std::remove_if(this->Contours.begin(), this->Contours.end(), isGone),
                       this->Contours.end());
}

Eigen::AlignedBox3d SliceContours::Bounds() const
{
  Eigen::AlignedBox3d box;
  for (const Contour& contour : this->Contours)
  {
    vtkPolyData* surface = contour.Surface->GetSurface();
    if (surface != nullptr && surface->GetNumberOfPoints() > 0 && !contour.Surface->GetWireframe())
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
  for (Contour& contour : this->Contours)
  {
    this->Update(contour, slice);
  }
}

void SliceContours::Update(Contour& contour, const SlicePosition& slice)
{
  vtkSurfaceDisplay* surface = contour.Surface;
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
      std::abs(height - contour.Height) < SameHeight && normal == contour.Normal;
  if (time != contour.Time || !isSamePlane)
  {
    contour.Curves->SetCurves(CutSurface(surface->GetSurface(), slice.CenterWorld, normal),
                              slice.Lift(ContourLayer));
    contour.Time = time;
    contour.Height = height;
    contour.Normal = normal;
    ++this->Cuts;
  }
}
} // namespace palpate
