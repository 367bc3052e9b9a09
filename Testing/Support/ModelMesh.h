#pragma once

#include "IcosahedronDirections.h"
#include "RadialModel.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace palpate::test
{
/// The surface of a model over the directions of an icosahedron, without arrays.
inline vtkSmartPointer<vtkPolyData> MakeModelMesh(const RadialModel& model, int frequency)
{
  const IcosahedronDirections directions(frequency);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& direction : directions.Directions())
  {
    points->InsertNextPoint(model.PointWorld(direction).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : directions.Triangles())
  {
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

/// A sphere's model; lengths mm.
inline RadialModel SphereModel(double radius, const Vector3& centerWorld)
{
  return {0, {radius * std::sqrt(4.0 * M_PI)}, centerWorld};
}
} // namespace palpate::test
