#include "SceneTool.h"

#include "InputError.h"
#include "Refusal.h"
#include "SampledTool.h"
#include "SurfaceTool.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
CutTool CapsuleTool(double radius, double length)
{
  const double half = 0.5 * length;
  const Vector3 reach(radius, radius, radius + half);
  return SampledTool(Eigen::AlignedBox3d(-reach, reach),
                     [=](const Vector3& p)
                     {
                       const double z = p[2] - std::clamp(p[2], -half, half);
                       return std::hypot(p[0], p[1], z) - radius;
                     });
}

// Exact at the surface, first-order accurate off it.
CutTool EllipsoidTool(const Vector3& axes)
{
  return SampledTool(Eigen::AlignedBox3d(-axes, axes),
                     [&axes](const Vector3& p)
                     {
                       const double scaled = p.cwiseQuotient(axes).norm();
                       const double steepness = p.cwiseQuotient(axes.cwiseProduct(axes)).norm();
                       return steepness > 0.0 ? scaled * (scaled - 1.0) / steepness
                                              : -axes.minCoeff();
                     });
}
} // namespace

ToolShape MakeTool(const TouchToolSettings& settings)
{
  const int points = ShellPointsOf(settings);
  ToolShape tool = ToolShape::Sphere(settings.Radius);
  if (settings.Kind == TouchToolSettings::Shape::Capsule)
  {
    tool = ToolShape::Capsule(settings.Radius, settings.Length, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Drill)
  {
    tool = ToolShape::Drill(settings.Radius, settings.ShaftRadius, settings.Length, points);
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

CutTool MakeCutTool(const TouchToolSettings& settings)
{
  CutTool tool = CutTool::Sphere(settings.Radius);
  if (settings.Kind == TouchToolSettings::Shape::Surface)
  {
    tool = SurfaceOf(settings, true)->Cutting();
  }
  else if (settings.Kind == TouchToolSettings::Shape::Ellipsoid)
  {
    if (!(settings.SemiAxes.minCoeff() > 0.0))
    {
      throw InputError("an ellipsoid without volume cannot drill; give three semi-axes above 0");
    }
    tool = EllipsoidTool(settings.SemiAxes);
  }
  else if (!(settings.Radius > 0.0))
  {
    throw InputError("a point cannot drill; give the tool a radius above 0");
  }
  else if (settings.Kind == TouchToolSettings::Shape::Cylinder)
  {
    tool = CutTool::Cylinder(settings.Radius, settings.Length);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Capsule)
  {
    tool = CapsuleTool(settings.Radius, settings.Length);
  }
  RequireInput(tool.Check(), "the tool cannot drill");
  return tool;
}

double DrillRadius(const TouchToolSettings& settings, const CutTool& tool)
{
  switch (settings.Kind)
  {
  case TouchToolSettings::Shape::Ellipsoid:
    return settings.SemiAxes.maxCoeff();
  case TouchToolSettings::Shape::Surface:
    return tool.BoundingRadius();
  default:
    return settings.Radius;
  }
}
} // namespace palpate
