#include "TouchView.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr SceneRenderer::Color StructureColor{{0.85, 0.72, 0.55}};
constexpr SceneRenderer::Color ToolColor{{0.15, 0.35, 0.75}};
} // namespace

TouchView::TouchView(const PreparedTouch& touch) : Drill(touch.Drill)
{
  for (const auto* structures : {&touch.Structures, &touch.OnlyDisplayed})
  {
    for (const BuiltStructure& structure : *structures)
    {
      this->Add(structure);
    }
  }
  this->Center = this->Renderer.CenterWorld();
  this->AddTool(touch.Scene->Tool);
}

void TouchView::Add(const BuiltStructure& structure)
{
  const TouchAppearance& looks = structure.Looks;
  if (looks.Field != nullptr)
  {
    const std::size_t number = this->Renderer.AddField(looks.Field, {StructureColor}, 1.0);
    if (structure.Drilled.Field != nullptr)
    {
      this->DrilledFields.push_back(number);
    }
  }
  if (looks.Surface != nullptr)
  {
    this->Renderer.AddSurface(looks.Surface, StructureColor, 1.0);
  }
}

// Drawn as its bounding sphere.
void TouchView::AddTool(const ToolShape& tool)
{
  constexpr double LeastRadius = 0.5; // mm, so that a point is visible
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(std::max(LeastRadius, tool.BoundingRadius()));
  sphere->SetCenter(this->Center.data());
  sphere->Update();
  this->Tool = this->Renderer.AddSurface(sphere->GetOutput(), ToolColor, 1.0);
}

const RasterImage& TouchView::Draw(double time, const Vector3& proxyWorld)
{
  constexpr double Turning = M_PI / 6.0; // rad/s
  if (this->Drill != nullptr)
  {
    const DrillReading newest = this->Drill->Editor().Newest();
    for (std::size_t site = 0; site < this->DrilledFields.size(); ++site)
    {
      this->Renderer.ChangeField(this->DrilledFields[site], newest.Fields[site]);
    }
  }
  const double angle = Turning * time;
  const Vector3 up = Vector3::UnitZ();
  const Vector3 right(std::cos(angle), std::sin(angle), 0.0);
  this->Renderer.MoveSurface(this->Tool, proxyWorld - this->Center);
  this->Renderer.Render({right, up, right.cross(up)}, this->Drawn);
  return this->Drawn;
}
} // namespace palpate
