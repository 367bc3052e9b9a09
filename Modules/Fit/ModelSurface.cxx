#include "ModelSurface.h"

#include "IcosahedronDirections.h"
#include "RadialModelSurface.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
vtkSmartPointer<vtkPolyData> Draw(const RadialModel& model, int frequency)
{
  return DrawRadialModel(model, frequency);
}

vtkSmartPointer<vtkPolyData> Draw(const SurfaceModel& surface, int frequency)
{
  const IcosahedronDirections sphere(frequency);
  const double side = surface.Volume() < 0.0 ? -1.0 : 1.0;
  TriangleMesh mesh;
  for (const Vector3& parameter : sphere.Directions())
  {
    mesh.PointsWorld.push_back(surface.Point(parameter));
    mesh.Normals.push_back(side * surface.Normal(parameter));
  }
  mesh.Triangles = sphere.Triangles();
  for (auto& triangle : mesh.Triangles)
  {
    if (side < 0.0)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return PolyDataOf(mesh);
}
} // namespace

vtkSmartPointer<vtkPolyData> DrawModel(const OrganModel& surface, int frequency)
{
  return std::visit([frequency](const auto& s) { return Draw(s, frequency); }, surface);
}

int DrawnFrequency(const OrganModel& surface, int frequency)
{
  const auto* mapped = std::get_if<SurfaceModel>(&surface);
  return mapped ? std::max(frequency, static_cast<int>(std::ceil(1.6 * mapped->Degree())))
                : frequency;
}
} // namespace palpate
