#include "LandmarksInSlice.h"

#include "DecimalText.h"

#include "vtkLandmarks.h"

#include "vtkActor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LineWidth = 1.5; // points

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

Vector3 PlaceOf(const vtkLandmarks& landmarks, int number)
{
  return Vector3(landmarks.GetLandmarks()[static_cast<std::size_t>(number)].PositionWorld.data());
}

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

void AddDistances(vtkLandmarks& landmarks, const SlicePosition& slice, Drawing& drawing)
{
  for (const auto& [from, to] : landmarks.GetDistances())
  {
    const Vector3 start = PlaceOf(landmarks, from);
    const Vector3 end = PlaceOf(landmarks, to);
    if (std::max(std::abs(slice.HeightOver(start)), std::abs(slice.HeightOver(end))) <
        landmarks.GetRadius())
    {
      const Vector3 a = slice.Projected(start);
      const Vector3 b = slice.Projected(end);
      drawing.Curves.push_back({{a, b}, false});
      drawing.Labels.push_back({FixedText((end - start).norm(), 1) + " mm", 0.5 * (a + b)});
    }
  }
}
} // namespace

void LandmarksInSlice::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != nullptr)
  {
    this->Renderer->RemoveViewProp(this->Marks.Actor());
  }
  this->Labels.SetRenderer(renderer);
  this->Renderer = renderer;
  if (renderer != nullptr)
  {
    renderer->AddViewProp(this->Marks.Actor());
  }
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
    AddDistances(*landmarks, slice, drawing);
  }
  this->Marks.SetCurves(drawing.Curves, slice.Lift(LandmarkLayer));
  this->Marks.SetStyle(color, 1.0, LineWidth * slice.PointPixels);
  this->Labels.Update(drawing.Labels, color);
}
} // namespace palpate
