#include "ModelSurface.h"

#include "FilterRun.h"
#include "IcosahedronDirections.h"
#include "ModelTable.h"
#include "TriangleMesh.h"
#include "vtkNew.h"
#include "vtkSphericalHarmonicSurface.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
vtkSmartPointer<vtkPolyData> Draw(const SphericalHarmonicModel& model, int frequency)
{
  vtkNew<vtkTable> table;
  ToTable(model, table);
  vtkNew<vtkSphericalHarmonicSurface> surface;
  surface->SetInputData(table);
  surface->SetFrequency(frequency);
  RunFilter(surface, "drawing", 0.0, 1.0, {});
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> Draw(const ParametricSphericalSurface& surface, int frequency)
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

vtkSmartPointer<vtkPolyData> DrawModel(const SurfaceModel& surface, int frequency)
{
  return std::visit([frequency](const auto& s) { return Draw(s, frequency); }, surface);
}

int DrawnFrequency(const SurfaceModel& surface, int frequency)
{
  const auto* parametric = std::get_if<ParametricSphericalSurface>(&surface);
  return parametric ? std::max(frequency, static_cast<int>(std::ceil(1.6 * parametric->Degree())))
                    : frequency;
}

vtkSmartPointer<vtkPolyData> DrawMesh(const IndexedMesh& mesh)
{
  TriangleMesh drawn;
  drawn.PointsWorld = mesh.Points;
  drawn.Triangles = mesh.Triangles;
  return PolyDataOf(drawn);
}
} // namespace palpate
