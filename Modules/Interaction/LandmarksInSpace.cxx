#include "LandmarksInSpace.h"

#include "ActorShaders.h"
#include "SurfaceMaterial.h"
#include "vtkLandmarks.h"

#include "vtkGlyph3D.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr int SphereResolution = 16;
constexpr double MeasureWidth = 2.0; // pixels
constexpr double TubeShare = 0.15;   // of the spheres' radius
constexpr int TubeSides = 8;
constexpr double RimShare = 1.2; // of a sphere's radius
constexpr double TubeRimShare = 1.8;
constexpr double MarkGhostOpacity = 0.3;
} // namespace

void LandmarksInSpace::Make(Solid& solid, vtkAlgorithmOutput* body, vtkAlgorithmOutput* rim)
{
  for (vtkActor* actor : {solid.Body.Get(), solid.Rim.Get(), solid.Ghost.Get()})
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(actor == solid.Rim.Get() ? rim : body);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->PickableOff();
  }
  SurfaceMaterial::Set(solid.Body->GetProperty());
  MakeRim(solid.Rim);
  solid.Ghost->GetProperty()->LightingOff();
  ShowThrough(solid.Ghost, MarkGhostOpacity);
}

void LandmarksInSpace::Show(Solid& solid, bool isShown, const double* color)
{
  for (vtkActor* actor : {solid.Body.Get(), solid.Rim.Get(), solid.Ghost.Get()})
  {
    actor->SetVisibility(isShown ? 1 : 0);
    if (isShown && actor != solid.Rim.Get())
    {
      actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    }
  }
}

LandmarksInSpace::LandmarksInSpace()
{
  vtkNew<vtkGlyph3D> glyphs;
  vtkNew<vtkGlyph3D> rims;
  for (const auto& [sphere, glyph] : {std::pair{this->Sphere.Get(), glyphs.Get()},
                                      std::pair{this->LargerSphere.Get(), rims.Get()}})
  {
    sphere->SetThetaResolution(SphereResolution);
    sphere->SetPhiResolution(SphereResolution);
    glyph->SetInputData(this->Places);
    glyph->SetSourceConnection(sphere->GetOutputPort());
    glyph->ScalingOff();
  }
  Make(this->Spheres, glyphs->GetOutputPort(), rims->GetOutputPort());
  for (vtkTubeFilter* tube : {this->Tube.Get(), this->WiderTube.Get()})
  {
    tube->SetInputData(this->Lines.Data());
    tube->SetNumberOfSides(TubeSides);
  }
  Make(this->Tubes, this->Tube->GetOutputPort(), this->WiderTube->GetOutputPort());
  this->Tubes.Body->GetProperty()->LightingOff();
}

void LandmarksInSpace::SetRenderer(vtkRenderer* renderer)
{
  for (vtkActor* actor : {this->Spheres.Body.Get(), this->Spheres.Rim.Get(),
                          this->Spheres.Ghost.Get(), this->Lines.Actor(), this->Tubes.Body.Get(),
                          this->Tubes.Rim.Get(), this->Tubes.Ghost.Get()})
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
  this->Time = Never;
  this->Renderer = renderer;
}

void LandmarksInSpace::Update(vtkLandmarks* landmarks)
{
  const vtkMTimeType time = landmarks != nullptr ? landmarks->GetMTime() : 0;
  if (landmarks == this->Shown && time == this->Time)
  {
    return;
  }
  this->Shown = landmarks;
  this->Time = time;
  const bool isShown = landmarks != nullptr && landmarks->GetNumberOfLandmarks() > 0;
  const bool hasCurves = landmarks != nullptr && !landmarks->GetCurves().empty();
  const double* shade = landmarks != nullptr ? landmarks->GetColor() : nullptr;
  Show(this->Spheres, isShown, shade);
  Show(this->Tubes, hasCurves, shade);
  this->Lines.SetVisible(hasCurves);
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
  const double radius = landmarks->GetRadius();
  const std::array<double, 3> color{{shade[0], shade[1], shade[2]}};
  this->Places->SetPoints(points);
  this->Sphere->SetRadius(radius);
  this->LargerSphere->SetRadius(RimShare * radius);
  this->Lines.SetCurves(lines, Vector3::Zero());
  this->Lines.SetStyle(color, 1.0, MeasureWidth);
  this->Tube->SetRadius(TubeShare * radius);
  this->WiderTube->SetRadius(TubeRimShare * TubeShare * radius);
  this->Labels.SetReach(RimShare * radius);
  this->Labels.Update(labels, color);
}
} // namespace palpate
