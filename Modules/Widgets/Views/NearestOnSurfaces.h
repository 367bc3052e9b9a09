#pragma once

#include "Vector3.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <map>
#include <optional>
#include <vector>

namespace palpate
{
/// Finds the place of some surfaces that is nearest to a point. A surface is prepared when it first
/// comes into question, and again when it changes.
class NearestOnSurfaces
{
public:
  void SetSurfaces(const std::vector<vtkPolyData*>& surfaces);
  /// World, mm; none if nothing is nearer than `most` (mm).
  std::optional<Vector3> Find(const Vector3& pointWorld, double most);

private:
  struct Prepared
  {
    vtkSmartPointer<vtkStaticCellLocator> Locator;
    vtkMTimeType Time = 0;
  };
  std::map<vtkSmartPointer<vtkPolyData>, Prepared> All;
};
} // namespace palpate
