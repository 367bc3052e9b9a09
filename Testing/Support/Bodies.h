#pragma once

#include "IcosahedronDirections.h"
#include "Vector3.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate::test
{
/// A closed surface with one vertex for each direction of an icosahedron, at place(direction).
template <typename Place>
vtkSmartPointer<vtkPolyData> MakeBody(int frequency, const Place& place)
{
  const IcosahedronDirections sphere(frequency);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& direction : sphere.Directions())
  {
    points->InsertNextPoint(Vector3(place(direction)).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : sphere.Triangles())
  {
    triangles->InsertNextCell({t[0], t[1], t[2]});
  }
  auto body = vtkSmartPointer<vtkPolyData>::New();
  body->SetPoints(points);
  body->SetPolys(triangles);
  return body;
}

inline vtkSmartPointer<vtkPolyData> MakeSphere(double radius, const Vector3& center,
                                               int frequency = 20)
{
  return MakeBody(frequency,
                  [&](const Vector3& direction) -> Vector3 { return center + radius * direction; });
}
} // namespace palpate::test
