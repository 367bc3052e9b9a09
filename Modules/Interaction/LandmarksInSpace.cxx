#include "LandmarksInSpace.h"

#include "DecimalText.h"

#include "vtkLandmarks.h"

#include "vtkGlyph3D.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace palpate
{
namespace
{
constexpr int SphereResolution = 16;
constexpr double LineWidth = 2.0; // pixels
} // namespace

LandmarksInSpace::LandmarksInSpace()
{
  this->Sphere->SetThetaResolution(SphereResolution);
  this->Sphere->SetPhiResolution(SphereResolution);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputData(this->Places);
  glyphs->SetSourceConnection(this->Sphere->GetOutputPort());
  glyphs->ScalingOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(glyphs->GetOutputPort());
  mapper->ScalarVisibilityOff();
  this->Spheres->SetMapper(mapper);
  this->Spheres->PickableOff();
}

void LandmarksInSpace::SetRenderer(vtkRenderer* renderer)
{
  for (vtkActor* actor : {this->Spheres.Get(), this->Distances.Actor()})
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

void LandmarksInSpace::Update(vtkLandmarks* landmarks)
{
  const bool isShown = landmarks != nullptr && landmarks->GetNumberOfLandmarks() > 0;
  this->Spheres->SetVisibility(isShown ? 1 : 0);
  this->Distances.SetVisible(isShown);
  if (!isShown)
  {
    this->Labels.Update({}, {});
    return;
  }
  vtkNew<vtkPoints> points;
  std::vector<PointLabels::Label> labels;
  for (const vtkLandmarks::Landmark& landmark : landmarks->GetLandmarks())
  {
    points->InsertNextPoint(landmark.PositionWorld.data());
    labels.push_back({landmark.Name, Vector3(landmark.PositionWorld.data())});
  }
  std::vector<SurfaceCurve> lines;
  for (const auto& [from, to] : landmarks->GetDistances())
  {
    const Vector3 a = labels[static_cast<std::size_t>(from)].PositionWorld;
    const Vector3 b = labels[static_cast<std::size_t>(to)].PositionWorld;
    lines.push_back({{a, b}, false});
    labels.push_back({FixedText((b - a).norm(), 1) + " mm", 0.5 * (a + b)});
  }
  const double* color = landmarks->GetColor();
  this->Places->SetPoints(points);
  this->Sphere->SetRadius(landmarks->GetRadius());
  this->Spheres->GetProperty()->SetColor(landmarks->GetColor());
  this->Distances.SetCurves(lines, Vector3::Zero());
  this->Distances.SetStyle({{color[0], color[1], color[2]}}, 1.0, LineWidth);
  this->Labels.Update(labels, {{color[0], color[1], color[2]}});
}
} // namespace palpate
