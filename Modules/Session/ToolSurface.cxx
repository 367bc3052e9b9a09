#include "ToolSurface.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LeastRadius = 0.5; // mm
constexpr int Resolution = 32;

// Where a point of the unit sphere lies on the tool.
Vector3 OnTool(const Vector3& unit, const TouchToolSettings& tool)
{
  if (tool.Kind == TouchToolSettings::Shape::Ellipsoid)
  {
    return unit.cwiseProduct(tool.SemiAxes.cwiseMax(LeastRadius));
  }
  const Vector3 round = std::max(tool.Radius, LeastRadius) * unit;
  const bool isLong = tool.Kind == TouchToolSettings::Shape::Capsule;
  return isLong ? Vector3(round + std::copysign(0.5 * tool.Length, unit.z()) * Vector3::UnitZ())
                : round;
}
} // namespace

vtkSmartPointer<vtkPolyData> MakeToolSurface(const TouchToolSettings& tool)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(Resolution);
  sphere->SetPhiResolution(Resolution);
  sphere->Update();
  vtkSmartPointer<vtkPolyData> surface = sphere->GetOutput();
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    const Vector3 point = OnTool(Vector3(surface->GetPoint(p)).normalized(), tool);
    surface->GetPoints()->SetPoint(p, point.data());
  }
  return surface;
}
} // namespace palpate
