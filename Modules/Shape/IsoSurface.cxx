#include "IsoSurface.h"

#include "DisjointSets.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
// A sample equal to the level would produce several vertices at one point; moving it by a millionth
// of the field's range changes nothing measurable.
void MoveOffLevel(ScalarGrid& grid, float level)
{
  const auto [low, high] = std::minmax_element(grid.Values.begin(), grid.Values.end());
  const float nudge = 1e-6f * std::max(*high - *low, std::abs(level));
  for (float& value : grid.Values)
  {
    if (std::abs(value - level) < nudge)
    {
      value = value < level ? level - nudge : level + nudge;
    }
  }
}

vtkSmartPointer<vtkPolyData> Contour(ScalarGrid& grid, float level)
{
  MoveOffLevel(grid, level);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetArray(grid.Values.data(), static_cast<vtkIdType>(grid.Values.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.Size.data());
  image->SetSpacing(grid.Spacing.data());
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, level);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

template <typename Visit>
void ForEachTriangle(vtkPolyData* surface, const Visit& visit)
{
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    visit(ids);
  }
}

/// The connected pieces of a surface.
class PiecesOfSurface
{
public:
  explicit PiecesOfSurface(vtkPolyData* surface)
      : Points(static_cast<std::size_t>(surface->GetNumberOfPoints()))
  {
    ForEachTriangle(surface,
                    [this](const vtkIdType* ids)
                    {
                      this->Points.Join(ids[0], ids[1]);
                      this->Points.Join(ids[0], ids[2]);
                    });
    std::vector<vtkIdType> triangles(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0);
    ForEachTriangle(surface, [&](const vtkIdType* ids)
                    { this->Count += ++triangles[this->Points.Root(ids[0])] == 1 ? 1 : 0; });
    this->Largest = static_cast<std::size_t>(std::max_element(triangles.begin(), triangles.end()) -
                                             triangles.begin());
  }

  int GetCount() const { return this->Count; }
  bool IsInLargest(vtkIdType point) { return this->Points.Root(point) == this->Largest; }

private:
  DisjointSets Points;
  std::size_t Largest = 0;
  int Count = 0;
};

// Of ids of 32 bits, half as large, which number what an image of any size makes.
vtkSmartPointer<vtkCellArray> TriangleArray(vtkIdType count)
{
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  if (3 * count <= std::numeric_limits<vtkTypeInt32>::max())
  {
    triangles->Use32BitStorage();
  }
  triangles->AllocateExact(count, 3 * count);
  return triangles;
}

// Takes one piece or all, without unused points, and orients triangles outwards.
IsoSurface Choose(vtkPolyData* surface, SurfacePieces pieces)
{
  PiecesOfSurface connected(surface);
  std::vector<vtkIdType> renumbered(static_cast<std::size_t>(surface->GetNumberOfPoints()), -1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto triangles = TriangleArray(surface->GetNumberOfPolys());
  const auto renumber = [&](vtkIdType id)
  {
    vtkIdType& entry = renumbered[static_cast<std::size_t>(id)];
    if (entry < 0)
    {
      entry = points->InsertNextPoint(surface->GetPoint(id));
    }
    return entry;
  };
  ForEachTriangle(
      surface,
      [&](const vtkIdType* ids)
      {
        if (pieces == SurfacePieces::All || connected.IsInLargest(ids[0]))
        {
          triangles->InsertNextCell({renumber(ids[0]), renumber(ids[1]), renumber(ids[2])});
        }
      });
  points->Squeeze();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  if (MeasureEnclosed(result).Volume < 0.0)
  {
    ReverseTriangles(result);
  }
  return {result, connected.GetCount(), 0.0};
}
} // namespace

EnclosedMeasure MeasureEnclosed(vtkPolyData* surface)
{
  EnclosedMeasure measure{0.0, 0.0};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (surface->GetNumberOfPoints() > 0)
  {
    surface->GetPoint(0, origin.data()); // close to the surface: less cancellation
  }
  ForEachTriangle(surface,
                  [&](const vtkIdType* ids)
                  {
                    Eigen::Vector3d a;
                    Eigen::Vector3d b;
                    Eigen::Vector3d c;
                    surface->GetPoint(ids[0], a.data());
                    surface->GetPoint(ids[1], b.data());
                    surface->GetPoint(ids[2], c.data());
                    const Eigen::Vector3d doubled = (b - a).cross(c - a);
                    measure.Volume += (a - origin).dot(doubled) / 6.0;
                    measure.Area += 0.5 * doubled.norm();
                  });
  return measure;
}

void ReverseTriangles(vtkPolyData* surface)
{
  const auto reversed = TriangleArray(surface->GetNumberOfPolys());
  ForEachTriangle(surface,
                  [&](const vtkIdType* ids) {
                    reversed->InsertNextCell({ids[0], ids[2], ids[1]});
                  });
  surface->SetPolys(reversed);
}

void MoveToWorld(const ScalarGrid& grid, vtkImageData* image, vtkPolyData* surface)
{
  const int* extent = image->GetExtent();
  vtkPoints* points = surface->GetPoints();
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double point[3];
    points->GetPoint(id, point);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = extent[2 * axis] + grid.StartIndex[axis] +
                    point[axis] / grid.Spacing[axis] * grid.StepIndex[axis];
    }
    double world[3];
    image->TransformContinuousIndexToPhysicalPoint(point, world);
    points->SetPoint(id, world);
  }
  if (image->GetDirectionMatrix()->Determinant() < 0.0)
  {
    ReverseTriangles(surface);
  }
}

IsoSurface ExtractIsoSurface(ScalarGrid& grid, float level, SurfacePieces pieces)
{
  IsoSurface result = Choose(Contour(grid, level), pieces);
  result.Level = level;
  return result;
}

IsoSurface ExtractIsoSurfaceOfVolume(ScalarGrid& grid, double volume, SurfacePieces pieces)
{
  const auto [lowest, highest] = std::minmax_element(grid.Values.begin(), grid.Values.end());
  double low = *lowest; // the surface's volume falls as the level rises
  double high = *highest;
  double level = 0.0;
  IsoSurface result;
  double lastLevel = 0.0;
  double lastExcess = 0.0;
  // Secant steps kept inside the bracket; the first step guesses the field's slope at the surface.
  for (int step = 0; step < 12; ++step)
  {
    result = ExtractIsoSurface(grid, static_cast<float>(level), pieces);
    const EnclosedMeasure measure = MeasureEnclosed(result.Surface);
    const double excess = measure.Volume - volume;
    if (std::abs(excess) <= 1e-3 * volume)
    {
      break;
    }
    (excess > 0.0 ? low : high) = level;
    const double slope =
        step == 0 || excess == lastExcess
            ? -measure.Area * std::cbrt(grid.Spacing[0] * grid.Spacing[1] * grid.Spacing[2])
            : (excess - lastExcess) / (level - lastLevel);
    lastLevel = level;
    lastExcess = excess;
    const double next = slope < 0.0 ? level - excess / slope : low;
    level = next > low && next < high ? next : 0.5 * (low + high);
  }
  return result;
}
} // namespace palpate
