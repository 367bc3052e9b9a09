#include "RadialModelSurface.h"

#include "ClosestPointDistances.h"
#include "DirectionCaster.h"
#include "FitDeviation.h"
#include "IcosahedronDirections.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <limits>

namespace palpate
{
namespace
{
vtkNew<vtkDoubleArray> MakeArray(const char* name, std::size_t count, int components = 1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

void AddGeometry(const RadialModel& model, const IcosahedronDirections& sphere, vtkPolyData* output)
{
  const std::vector<Vector3>& directions = sphere.Directions();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(directions.size()));
  auto radii = MakeArray("Radius", directions.size());
  auto normals = MakeArray("Normals", directions.size(), 3);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const double radius = model.Radius(directions[i]);
    points->SetPoint(id, Vector3(model.CenterWorld() + radius * directions[i]).data());
    radii->SetValue(id, radius);
    normals->SetTuple(id, model.Normal(directions[i]).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& t : sphere.Triangles())
  {
    triangles->InsertNextCell({t[0], t[1], t[2]});
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(radii);
  output->GetPointData()->SetNormals(normals);
}

void AddComparison(const RadialModel& model, const std::vector<Vector3>& directions,
                   const IndexedMesh& mesh, vtkPolyData* output)
{
  const auto crossings = DirectionCaster(directions).Cast(mesh, model.CenterWorld());
  std::vector<double> radii(directions.size());
  std::vector<Vector3> points(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    radii[i] = model.Radius(directions[i]);
    points[i] = model.CenterWorld() + radii[i] * directions[i];
  }
  const std::vector<double> distances = ClosestPointDistances(points, mesh);
  auto signedDistances = MakeArray("DistanceToSurface", directions.size());
  auto residuals = MakeArray("Residual", directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const bool isInside = IsInside(crossings[i], radii[i]);
    signedDistances->SetValue(id, isInside ? -distances[i] : distances[i]);
    residuals->SetValue(id, crossings[i].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                 : crossings[i].back().Distance - radii[i]);
  }
  output->GetPointData()->AddArray(signedDistances);
  output->GetPointData()->AddArray(residuals);
}
} // namespace

vtkSmartPointer<vtkPolyData> DrawRadialModel(const RadialModel& model, int frequency,
                                             const RadialComparison& compared)
{
  const IcosahedronDirections sphere(frequency);
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  AddGeometry(model, sphere, drawn);
  if (compared.Factor != nullptr)
  {
    drawn->GetPointData()->AddArray(
        FitDeviation(*compared.Factor, sphere.Directions(), "RadiusDeviation"));
  }
  if (compared.Original != nullptr && !compared.Original->Triangles.empty())
  {
    AddComparison(model, sphere.Directions(), *compared.Original, drawn);
  }
  return drawn;
}
} // namespace palpate
