#include "MeshConversion.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"

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
} // namespace palpate
