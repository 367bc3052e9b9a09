#include "SurfaceTool.h"

#include "Refusal.h"
#include "SampledTool.h"
#include "SurfaceFile.h"

#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"

#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadClosedSurface(const std::filesystem::path& file)
{
  // Files whose triangles have points of their own, as for shading, are closed where these agree.
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputData(ReadSurface(file));
  joined->SetTolerance(0.0);
  joined->Update();
  vtkPolyData* surface = joined->GetOutput();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  if (edges->GetOutput()->GetNumberOfCells() > 0)
  {
    Refuse(file, "cannot be a tool, since its surface is not closed", "close it, as for printing");
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->AutoOrientNormalsOn();
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

Vector3 PointOf(vtkPolyData& surface, vtkIdType number)
{
  Vector3 point;
  surface.GetPoint(number, point.data());
  return point;
}

// Each the farthest from all before it.
std::vector<vtkIdType> FarPoints(vtkPolyData& surface, int count)
{
  const vtkIdType all = surface.GetNumberOfPoints();
  std::vector<double> squared(static_cast<std::size_t>(all), std::numeric_limits<double>::max());
  std::vector<vtkIdType> chosen{0};
  while (static_cast<int>(chosen.size()) < std::min<vtkIdType>(count, all))
  {
    const Vector3 last = PointOf(surface, chosen.back());
    vtkIdType farthest = 0;
    for (vtkIdType n = 0; n < all; ++n)
    {
      double& one = squared[static_cast<std::size_t>(n)];
      one = std::min(one, (PointOf(surface, n) - last).squaredNorm());
      farthest = one > squared[static_cast<std::size_t>(farthest)] ? n : farthest;
    }
    chosen.push_back(farthest);
  }
  return chosen;
}
} // namespace

ToolShape MakeSurfaceTool(const std::filesystem::path& file, int count)
{
  const vtkSmartPointer<vtkPolyData> surface = ReadClosedSurface(file);
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  for (const vtkIdType number : FarPoints(*surface, count))
  {
    Vector3 outward;
    surface->GetPointData()->GetNormals()->GetTuple(number, outward.data());
    points.push_back(PointOf(*surface, number));
    normals.push_back(-outward);
  }
  return ToolShape::FromSurfacePoints(std::move(points), std::move(normals));
}

CutTool MakeSurfaceCutTool(const std::filesystem::path& file)
{
  const vtkSmartPointer<vtkPolyData> surface = ReadClosedSurface(file);
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(surface);
  std::array<double, 6> bounds{};
  surface->GetBounds(bounds.data());
  const Eigen::AlignedBox3d box(Vector3(bounds[0], bounds[2], bounds[4]),
                                Vector3(bounds[1], bounds[3], bounds[5]));
  if (!(box.sizes().minCoeff() > 0.0))
  {
    Refuse(file, "cannot be a drill, since it has no inside", "give a surface round some volume");
  }
  return SampledTool(box, [&distance](Vector3 point)
                     { return distance->EvaluateFunction(point.data()); });
}
} // namespace palpate
