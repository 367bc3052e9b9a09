#include "LandmarksInSlice.h"

#include "vtkLandmarks.h"

#include "vtkActor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double CrossWidth = 1.5; // points

SurfaceCurve Circle(const Vector3& center, double radius, const ViewFrame& frame)
{
  constexpr int Corners = 36;
  SurfaceCurve circle;
  circle.IsClosed = true;
  for (int c = 0; c < Corners; ++c)
  {
    const double angle = 2.0 * M_PI * c / Corners;
    circle.Points.push_back(
        center + radius * (std::cos(angle) * frame.RightWorld + std::sin(angle) * frame.UpWorld));
  }
  return circle;
}

struct Drawing
{
  std::vector<SurfaceCurve> Curves;
  std::vector<PointLabels::Label> Labels;
};

void AddSpheres(vtkLandmarks& landmarks, const SlicePosition& slice, Drawing& drawing)
{
  const double radius = landmarks.GetRadius();
  for (const vtkLandmarks::Landmark& landmark : landmarks.GetLandmarks())
  {
    const Vector3 place(landmark.PositionWorld.data());
    const double height = slice.HeightOver(place);
    if (std::abs(height) < radius)
    {
      const double cut = std::sqrt(radius * radius - height * height);
      const Vector3 center = slice.Projected(place);
      drawing.Curves.push_back(Circle(center, cut, slice.Frame));
      drawing.Labels.push_back({landmark.Name, center + cut * slice.Frame.RightWorld});
    }
  }
}

// The part of a segment whose height over the slice is within reach, as fractions; empty if the
// first one is larger.
std::pair<double, double> PartWithin(double from, double to, double reach)
{
  std::pair<double, double> part{0.0, 1.0};
  for (const double sign : {1.0, -1.0})
  {
    const double before = sign * from - reach; // positive: out of reach
    const double after = sign * to - reach;
    if (before > 0.0 && after > 0.0)
    {
      return {1.0, 0.0};
    }
    const double fraction = before / (before - after);
    part.first = before > 0.0 ? std::max(part.first, fraction) : part.first;
    part.second = after > 0.0 ? std::min(part.second, fraction) : part.second;
  }
  return part;
}

// The parts of a curve within reach of the slice, projected on it.
std::vector<SurfaceCurve> PartsOf(const vtkLandmarks::Curve& curve, const SlicePosition& slice,
                                  double reach)
{
  std::vector<SurfaceCurve> parts;
  bool isGoingOn = false;
  const std::size_t count = curve.Points.size();
  for (std::size_t i = 0; i + 1 < count + (curve.IsClosed ? 1 : 0); ++i)
  {
    const Vector3 from(curve.Points[i].data());
    const Vector3 to(curve.Points[(i + 1) % count].data());
    const auto [first, last] = PartWithin(slice.HeightOver(from), slice.HeightOver(to), reach);
    if (first > last)
    {
      isGoingOn = false;
      continue;
    }
    if (!isGoingOn || first > 0.0)
    {
      parts.push_back({{slice.Projected(from + first * (to - from))}, false});
    }
    parts.back().Points.push_back(slice.Projected(from + last * (to - from)));
    isGoingOn = last == 1.0;
  }
  return parts;
}

void AddCurves(vtkLandmarks& landmarks, const SlicePosition& slice, Drawing& drawing)
{
  const double reach = landmarks.GetRadius();
  for (const vtkLandmarks::Curve& curve : landmarks.GetCurves())
  {
    const std::vector<SurfaceCurve> parts = PartsOf(curve, slice, reach);
    if (!parts.empty())
    {
      const Vector3 place(curve.LabelWorld.data());
      const bool isNear = std::abs(slice.HeightOver(place)) < reach;
      drawing.Labels.push_back(
          {curve.Label, isNear ? slice.Projected(place) : parts.front().Points.front()});
      drawing.Curves.insert(drawing.Curves.end(), parts.begin(), parts.end());
    }
  }
}
} // namespace

void LandmarksInSlice::SetRenderer(vtkRenderer* renderer)
{
  for (vtkActor* actor : this->Marks.Actors())
  {
    if (this->Renderer != nullptr)
    {
      this->Renderer->RemoveViewProp(actor);
    }
    if (renderer != nullptr)
    {
      renderer->AddViewProp(actor);
    }
  }
  this->Labels.SetRenderer(renderer);
  this->Renderer = renderer;
}

void LandmarksInSlice::Update(vtkLandmarks* landmarks, const SlicePosition& slice)
{
  Drawing drawing;
  std::array<double, 3> color{};
  if (landmarks != nullptr)
  {
    const double* shade = landmarks->GetColor();
    color = {{shade[0], shade[1], shade[2]}};
    AddSpheres(*landmarks, slice, drawing);
    AddCurves(*landmarks, slice, drawing);
  }
  this->Marks.SetCurves(drawing.Curves, slice.Lift(LandmarkLayer));
  this->Marks.SetStyle(color, 1.0, CrossWidth * slice.PointPixels);
  this->Labels.Update(drawing.Labels, color);
}
} // namespace palpate
