#include "ToolSurface.h"

#include "vtkAppendPolyData.h"
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

namespace
{
// The convex hull of the points of the part that cuts, or of the other.
vtkSmartPointer<vtkPolyData> HullOf(const ToolShape& tool, bool cuts)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t n = 0; n < tool.Points().size(); ++n)
  {
    if (tool.BallAt(n).Cuts == cuts)
    {
      points->InsertNextPoint(tool.Points()[n].data());
    }
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
} // namespace

vtkSmartPointer<vtkPolyData> MakeToolSurface(const ToolShape& tool)
{
  if (tool.IsSphere())
  {
    return MakeToolSphere(tool.Radius());
  }
  vtkNew<vtkAppendPolyData> parts;
  parts->AddInputData(HullOf(tool, true));
  if (!tool.BallAt(tool.Points().size() - 1).Cuts)
  {
    parts->AddInputData(HullOf(tool, false));
  }
  parts->Update();
  return parts->GetOutput();
}
} // namespace palpate
