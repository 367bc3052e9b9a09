#pragma once

#include "PalpateInteractionModule.h"

#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkLookupTable;

namespace palpate
{
class SurfaceInSpace;

/// Colours of surfaces that arrays colour: one scale for all that an array of one name does, so
/// that they can be compared and one bar speaks for all.
class PALPATEINTERACTION_EXPORT ArrayScales
{
public:
  /// Gives the surfaces their colours.
  void Update(const std::vector<std::unique_ptr<SurfaceInSpace>>& surfaces);

  /// Of the array that has a bar: by its name the first; null and empty where none colours
  /// anything.
  vtkLookupTable* FirstColors() const;
  std::string FirstArray() const;

private:
  struct Scale
  {
    std::array<double, 2> Range{};
    vtkSmartPointer<vtkLookupTable> Colors;
  };
  std::map<std::string, Scale> Scales;
};
} // namespace palpate
