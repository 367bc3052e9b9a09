#include "SurfaceTool.h"

#include "Refusal.h"
#include "SampledTool.h"
#include "SurfaceFile.h"

#include "vtkAdaptiveSubdivisionFilter.h"
#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->AutoOrientNormalsOn();
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadClosedSurface(const std::filesystem::path& file)
{
  // Files may repeat points per triangle, as for shading; equal points are merged first.
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputData(ReadSurface(file));
  joined->SetTolerance(0.0);
  joined->Update();
  vtkPolyData* surface = joined->GetOutput();
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    Refuse(file, "cannot be used as a tool, since its triangles have no area",
           "choose a surface that is closed, as for 3D printing");
  }
  // Of merged points only the first one's normals are left, which VTK 9.6 would keep.
  surface->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  if (edges->GetOutput()->GetNumberOfCells() > 0)
  {
    Refuse(file, "cannot be used as a tool, since its surface is not closed",
           "close it, as for 3D printing");
  }
  return WithNormals(surface);
}

// With at least `count` points, however few triangles flat sides have: one for each square of the
// area, but of slivers fewer.
vtkSmartPointer<vtkPolyData> Subdivided(vtkPolyData* surface, int count)
{
  constexpr double ShortestPart = 0.005; // of the largest extent
  if (surface->GetNumberOfPoints() >= count)
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  vtkNew<vtkMassProperties> area;
  area->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkAdaptiveSubdivisionFilter> fine;
  fine->SetInputConnection(triangles->GetOutputPort());
  fine->SetMaximumEdgeLength(
      std::max(std::sqrt(area->GetSurfaceArea() / count), ShortestPart * surface->GetLength()));
  fine->Update();
  return WithNormals(fine->GetOutput());
}

Vector3 PointOf(vtkPolyData& surface, vtkIdType number)
{
  Vector3 point;
  surface.GetPoint(number, point.data());
  return point;
}

// Each point is the farthest from all before it, so more points only append to the list.
std::vector<vtkIdType> FarPointsOf(vtkPolyData& surface, int count)
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

Eigen::AlignedBox3d BoxOf(vtkPolyData& surface)
{
  std::array<double, 6> bounds{};
  surface.GetBounds(bounds.data());
  return {Vector3(bounds[0], bounds[2], bounds[4]), Vector3(bounds[1], bounds[3], bounds[5])};
}
} // namespace

SurfaceTool::SurfaceTool(std::filesystem::path file, vtkSmartPointer<vtkPolyData> surface)
    : Source(std::move(file)), Surface(std::move(surface))
{
}

std::shared_ptr<const SurfaceTool> SurfaceTool::Read(const std::filesystem::path& file, int points,
                                                     bool cuts)
{
  std::shared_ptr<SurfaceTool> tool(new SurfaceTool(file, ReadClosedSurface(file)));
  tool->Surface->ComputeBounds();
  tool->Dense = Subdivided(tool->Surface, points);
  tool->FarPoints = FarPointsOf(*tool->Dense, points);
  if (cuts && BoxOf(*tool->Surface).sizes().minCoeff() > 0.0)
  {
    tool->Cut = tool->SampleCut();
  }
  return tool;
}

ToolShape SurfaceTool::Touching(int count) const
{
  const vtkIdType most = std::min<vtkIdType>(count, this->Dense->GetNumberOfPoints());
  std::vector<vtkIdType> numbers = this->FarPoints;
  if (static_cast<vtkIdType>(numbers.size()) < most)
  {
    numbers = FarPointsOf(*this->Dense, count);
  }
  numbers.resize(static_cast<std::size_t>(most));
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  for (const vtkIdType number : numbers)
  {
    Vector3 outward;
    this->Dense->GetPointData()->GetNormals()->GetTuple(number, outward.data());
    points.push_back(PointOf(*this->Dense, number));
    normals.push_back(-outward);
  }
  return ToolShape::FromSurfacePoints(std::move(points), std::move(normals));
}

CutTool SurfaceTool::Cutting() const
{
  if (!(BoxOf(*this->Surface).sizes().minCoeff() > 0.0))
  {
    Refuse(this->Source, "cannot be used as a drill, since it encloses no volume",
           "use a surface that encloses a volume");
  }
  return this->Cut ? *this->Cut : this->SampleCut();
}

CutTool SurfaceTool::SampleCut() const
{
  // The search structure modifies its input, which other threads may be reading.
  vtkNew<vtkPolyData> own;
  own->DeepCopy(this->Surface);
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(own);
  return SampledTool(BoxOf(*this->Surface), [&distance](Vector3 point)
                     { return distance->EvaluateFunction(point.data()); });
}

std::size_t SurfaceTool::Bytes() const
{
  constexpr std::size_t Kibibyte = 1024;
  return Kibibyte * (this->Surface->GetActualMemorySize() + this->Dense->GetActualMemorySize());
}

int ShellPointsOf(const TouchToolSettings& settings)
{
  return std::max(settings.Points, TouchToolSettings::SurfacePoints);
}

std::shared_ptr<const SurfaceTool> SurfaceOf(const TouchToolSettings& settings, bool cuts)
{
  return settings.Surface != nullptr
             ? settings.Surface
             : SurfaceTool::Read(settings.File, ShellPointsOf(settings), cuts);
}
} // namespace palpate
