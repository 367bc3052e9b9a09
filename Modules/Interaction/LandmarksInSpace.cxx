#include "LandmarksInSpace.h"

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
constexpr double MeasureWidth = 2.0; // pixels
constexpr double TubeShare = 0.15;   // of the spheres' radius
constexpr int TubeSides = 8;
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
  this->Tube->SetInputData(this->Lines.Data());
  this->Tube->SetNumberOfSides(TubeSides);
  vtkNew<vtkPolyDataMapper> tubeMapper;
  tubeMapper->SetInputConnection(this->Tube->GetOutputPort());
  tubeMapper->ScalarVisibilityOff();
  this->Tubes->SetMapper(tubeMapper);
  this->Tubes->GetProperty()->LightingOff();
  this->Tubes->PickableOff();
}

void LandmarksInSpace::SetRenderer(vtkRenderer* renderer)
{
  for (vtkActor* actor : {this->Spheres.Get(), this->Lines.Actor(), this->Tubes.Get()})
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
  const bool hasCurves = landmarks != nullptr && !landmarks->GetCurves().empty();
  this->Spheres->SetVisibility(isShown ? 1 : 0);
  this->Lines.SetVisible(hasCurves);
  this->Tubes->SetVisibility(hasCurves ? 1 : 0);
  if (!isShown && !hasCurves)
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
  for (const vtkLandmarks::Curve& curve : landmarks->GetCurves())
  {
    SurfaceCurve line;
    line.IsClosed = curve.IsClosed;
    for (const std::array<double, 3>& point : curve.Points)
    {
      line.Points.emplace_back(point.data());
    }
    lines.push_back(line);
    labels.push_back({curve.Label, Vector3(curve.LabelWorld.data())});
  }
  const double* shade = landmarks->GetColor();
  const std::array<double, 3> color{{shade[0], shade[1], shade[2]}};
  this->Places->SetPoints(points);
  this->Sphere->SetRadius(landmarks->GetRadius());
  this->Spheres->GetProperty()->SetColor(landmarks->GetColor());
  this->Lines.SetCurves(lines, Vector3::Zero());
  this->Lines.SetStyle(color, 1.0, MeasureWidth);
  this->Tube->SetRadius(TubeShare * landmarks->GetRadius());
  this->Tubes->GetProperty()->SetColor(landmarks->GetColor());
  this->Labels.Update(labels, color);
}
} // namespace palpate
