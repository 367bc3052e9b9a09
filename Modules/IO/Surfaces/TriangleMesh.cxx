#include "TriangleMesh.h"

#include "Refusal.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace palpate
{
namespace
{
std::vector<Vector3> Vectors(vtkDataArray* array)
{
  std::vector<Vector3> result(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), result[i].data());
  }
  return result;
}

std::vector<std::array<unsigned char, 3>> ColorsOf(vtkPointData* data)
{
  std::vector<std::array<unsigned char, 3>> result;
  auto* colors = vtkUnsignedCharArray::SafeDownCast(data->GetScalars());
  if (colors != nullptr && colors->GetNumberOfComponents() >= 3)
  {
    for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
    {
      result.push_back({colors->GetTypedComponent(i, 0), colors->GetTypedComponent(i, 1),
                        colors->GetTypedComponent(i, 2)});
    }
  }
  return result;
}

std::vector<TriangleMesh::PointValues> ValuesOf(vtkPointData* data)
{
  std::vector<TriangleMesh::PointValues> result;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    if (array == nullptr || array->GetNumberOfComponents() != 1 || array->GetName() == nullptr)
    {
      continue;
    }
    std::vector<double> numbers;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      numbers.push_back(array->GetComponent(i, 0));
    }
    result.push_back({array->GetName(), std::move(numbers)});
  }
  return result;
}

std::vector<std::array<int, 3>> TriangleIndices(vtkPolyData* surface)
{
  std::vector<std::array<int, 3>> result;
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(count, corners);
    if (count == 3)
    {
      result.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[1]),
                        static_cast<int>(corners[2])});
    }
  }
  return result;
}

// Checks the indices and lengths that VTK's filters and our writers use unchecked.
void CheckIndices(vtkPolyData* surface, const std::filesystem::path& file)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  if (points > std::numeric_limits<int>::max())
  {
    Refuse(file, "has more points than surface formats can number", "use a coarser surface");
  }
  for (vtkCellArray* cells :
       {surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips()})
  {
    bool isSound = cells->IsValid();
    vtkDataArray* corners = cells->GetConnectivityArray();
    for (vtkIdType i = 0; isSound && i < corners->GetNumberOfTuples(); ++i)
    {
      const auto corner = static_cast<vtkIdType>(corners->GetComponent(i, 0));
      isSound = corner >= 0 && corner < points;
    }
    if (!isSound)
    {
      Refuse(file, "has a cell that refers to a point that does not exist",
             "write the surface again");
    }
  }
  vtkPointData* data = surface->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    if (data->GetAbstractArray(a)->GetNumberOfTuples() != points)
    {
      Refuse(file, "has an array whose number of values differs from its number of points",
             "write the surface again");
    }
  }
}

void AddColorsAndValues(const TriangleMesh& mesh, vtkPointData* data)
{
  for (const TriangleMesh::PointValues& values : mesh.Values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(values.Name.c_str());
    for (const double number : values.Numbers)
    {
      array->InsertNextValue(number);
    }
    data->AddArray(array);
  }
  if (!mesh.Colors.empty())
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("Colors");
    colors->SetNumberOfComponents(3);
    for (const auto& color : mesh.Colors)
    {
      colors->InsertNextTypedTuple(color.data());
    }
    data->SetScalars(colors);
  }
}
// Removes points that were merged into others, and triangles that became edges.
void RenumberPoints(std::vector<int>& merged, TriangleMesh& mesh)
{
  std::vector<Vector3> kept;
  for (std::size_t i = 0; i < merged.size(); ++i)
  {
    const bool isKept = merged[i] == static_cast<int>(i);
    // Points before this one have their new number by now.
    merged[i] =
        isKept ? static_cast<int>(kept.size()) : merged[static_cast<std::size_t>(merged[i])];
    if (isKept)
    {
      kept.push_back(mesh.PointsWorld[i]);
    }
  }
  mesh.PointsWorld = std::move(kept);
  for (auto& triangle : mesh.Triangles)
  {
    for (int& corner : triangle)
    {
      corner = merged[static_cast<std::size_t>(corner)];
    }
  }
  mesh.Triangles.erase(std::remove_if(mesh.Triangles.begin(), mesh.Triangles.end(),
                                      [](const std::array<int, 3>& t)
                                      { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
                       mesh.Triangles.end());
}
} // namespace

// By sorting, which takes the same time for every file.
void MergeEqualPoints(TriangleMesh& mesh)
{
  const std::vector<Vector3>& points = mesh.PointsWorld;
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&points](int i) -> const Vector3&
  { return points[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&at](int a, int b)
            {
              const double* const p = at(a).data();
              const double* const q = at(b).data();
              return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
            });
  std::vector<int> merged(points.size());
  int first = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    first = i > 0 && at(order[i]) == at(first) ? first : order[i];
    merged[static_cast<std::size_t>(order[i])] = first;
  }
  RenumberPoints(merged, mesh);
}

TriangleMesh TrianglesOf(vtkPolyData* surface, const std::filesystem::path& file)
{
  CheckIndices(surface, file);
  vtkNew<vtkTriangleFilter> cut;
  cut->PassVertsOff();
  cut->PassLinesOff();
  cut->SetInputData(surface);
  cut->Update();
  vtkPolyData* triangles = cut->GetOutput();
  if (triangles->GetNumberOfPolys() == 0)
  {
    Refuse(file, "has no triangles", "use a closed surface");
  }
  TriangleMesh mesh;
  mesh.PointsWorld = Vectors(triangles->GetPoints()->GetData());
  mesh.SinglePrecision = triangles->GetPoints()->GetDataType() == VTK_FLOAT;
  for (const Vector3& point : mesh.PointsWorld)
  {
    if (!point.allFinite())
    {
      Refuse(file, "has a point whose coordinates are not finite", "create the surface again");
    }
  }
  vtkPointData* data = triangles->GetPointData();
  if (data->GetNormals() != nullptr)
  {
    mesh.Normals = Vectors(data->GetNormals());
  }
  mesh.Colors = ColorsOf(data);
  mesh.Values = ValuesOf(data);
  mesh.Triangles = TriangleIndices(triangles);
  return mesh;
}

vtkSmartPointer<vtkPolyData> PolyDataOf(const TriangleMesh& mesh)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh.SinglePrecision ? VTK_FLOAT : VTK_DOUBLE);
  for (const Vector3& point : mesh.PointsWorld)
  {
    points->InsertNextPoint(point.data());
  }
  surface->SetPoints(points);
  vtkNew<vtkCellArray> faces;
  for (const auto& triangle : mesh.Triangles)
  {
    faces->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  }
  surface->SetPolys(faces);
  if (!mesh.Normals.empty())
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (const Vector3& normal : mesh.Normals)
    {
      normals->InsertNextTuple(normal.data());
    }
    surface->GetPointData()->SetNormals(normals);
  }
  AddColorsAndValues(mesh, surface->GetPointData());
  return surface;
}
} // namespace palpate
