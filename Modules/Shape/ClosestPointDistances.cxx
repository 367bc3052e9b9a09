#include "ClosestPointDistances.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

#include <cmath>

namespace palpate
{
std::vector<double> ClosestPointDistances(vtkPoints* points, vtkPolyData* surface)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  std::vector<double> distances(static_cast<std::size_t>(points->GetNumberOfPoints()));
  vtkSMPThreadLocalObject<vtkGenericCell> cells;
  vtkSMPTools::For(0, points->GetNumberOfPoints(),
                   [&](vtkIdType first, vtkIdType last)
                   {
                     vtkGenericCell* cell = cells.Local();
                     for (vtkIdType id = first; id < last; ++id)
                     {
                       double point[3];
                       double closest[3];
                       vtkIdType cellId = -1;
                       int subId = 0;
                       double squared = 0.0;
                       points->GetPoint(id, point);
                       locator->FindClosestPoint(point, closest, cell, cellId, subId, squared);
                       distances[static_cast<std::size_t>(id)] = std::sqrt(squared);
                     }
                   });
  return distances;
}

std::vector<double> PointAreas(vtkPolyData* surface)
{
  std::vector<double> areas(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0.0);
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    double corners[3][3];
    for (int corner = 0; corner < 3; ++corner)
    {
      surface->GetPoint(ids[corner], corners[corner]);
    }
    const double third = vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]) / 3.0;
    for (int corner = 0; corner < 3; ++corner)
    {
      areas[static_cast<std::size_t>(ids[corner])] += third;
    }
  }
  return areas;
}
} // namespace palpate
