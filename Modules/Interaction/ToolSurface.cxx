#include "ToolSurface.h"

#include "vtkDelaunay3D.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
vtkSmartPointer<vtkPolyData> MakeToolSphere(double radius)
{
  constexpr double LeastRadius = 0.5;
  constexpr int Resolution = 32;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(std::isfinite(radius) ? std::max(LeastRadius, radius) : LeastRadius);
  sphere->SetThetaResolution(Resolution);
  sphere->SetPhiResolution(Resolution);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeToolSurface(const ToolShape& tool)
{
  if (tool.IsSphere())
  {
    return MakeToolSphere(tool.Radius());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& point : tool.Points())
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkPolyData> shell;
  shell->SetPoints(points);
  vtkNew<vtkDelaunay3D> tetrahedra;
  tetrahedra->SetInputData(shell);
  vtkNew<vtkGeometryFilter> hull;
  hull->SetInputConnection(tetrahedra->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(hull->GetOutputPort());
  normals->AutoOrientNormalsOn();
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}
} // namespace palpate
