#include "MeshConversion.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"

namespace palpate
{
IndexedMesh ToIndexedMesh(vtkPolyData* surface)
{
  IndexedMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  mesh.Triangles.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    if (count == 3)
    {
      mesh.Triangles.push_back(
          {static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2])});
    }
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const IndexedMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  // Of ids of 32 bits, half as large, which number what a mesh of this kind can have.
  vtkNew<vtkCellArray> triangles;
  triangles->Use32BitStorage();
  const auto count = static_cast<vtkIdType>(mesh.Triangles.size());
  triangles->AllocateExact(count, 3 * count);
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    triangles->InsertNextCell({a, b, c});
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}
} // namespace palpate
