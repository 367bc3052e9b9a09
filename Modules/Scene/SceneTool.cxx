#include "SceneTool.h"

#include "Refusal.h"
#include "SurfaceTool.h"

namespace palpate
{
ToolShape MakeTool(const TouchToolSettings& settings)
{
  const int points = ShellPointsOf(settings);
  ToolShape tool = ToolShape::Sphere(settings.Radius);
  if (settings.Kind == TouchToolSettings::Shape::Capsule)
  {
    tool = ToolShape::Capsule(settings.Radius, settings.Length, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Ellipsoid)
  {
    tool = ToolShape::Ellipsoid(settings.SemiAxes, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Cylinder)
  {
    tool = ToolShape::Cylinder(settings.Radius, settings.Length, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Surface)
  {
    tool = SurfaceOf(settings, false)->Touching(points);
  }
  else if (settings.Points > 0)
  {
    tool = ToolShape::SpherePoints(settings.Radius, settings.Points);
  }
  RequireInput(tool.Check(), "the tool cannot touch");
  return tool;
}
} // namespace palpate
