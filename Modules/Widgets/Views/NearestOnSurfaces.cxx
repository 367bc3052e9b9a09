#include "NearestOnSurfaces.h"

#include "vtkBoundingBox.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <cmath>
#include <iterator>
#include <set>

namespace palpate
{
void NearestOnSurfaces::SetSurfaces(const std::vector<vtkPolyData*>& surfaces)
{
  const std::set<vtkPolyData*> next(surfaces.begin(), surfaces.end());
  for (auto one = this->All.begin(); one != this->All.end();)
  {
    one = next.count(one->first) > 0 ? std::next(one) : this->All.erase(one);
  }
  for (vtkPolyData* surface : next)
  {
    this->All[surface];
  }
}

std::optional<Vector3> NearestOnSurfaces::Find(const Vector3& pointWorld, double most)
{
  Vector3 place = pointWorld; // VTK wants it to be changeable
  std::optional<Vector3> nearest;
  double reach = most;
  for (auto& [surface, prepared] : this->All)
  {
    vtkBoundingBox box(surface->GetBounds());
    box.Inflate(reach);
    if (surface->GetNumberOfCells() == 0 || !box.ContainsPoint(pointWorld.data()))
    {
      continue;
    }
    if (prepared.Time < surface->GetMTime())
    {
      prepared.Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
      prepared.Locator->SetDataSet(surface);
      prepared.Locator->BuildLocator();
      prepared.Time = surface->GetMTime();
    }
    Vector3 found;
    double square = 0.0;
    vtkIdType cell = 0;
    int part = 0;
    vtkNew<vtkGenericCell> buffer;
    if (prepared.Locator->FindClosestPointWithinRadius(place.data(), reach, found.data(), buffer,
                                                       cell, part, square) != 0)
    {
      reach = std::sqrt(square);
      nearest = found;
    }
  }
  return nearest;
}
} // namespace palpate
