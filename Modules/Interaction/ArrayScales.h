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

/// Colour scales of surfaces: one for all surfaces coloured by an array of the same name, so that
/// they can be compared and share one bar.
class PALPATEINTERACTION_EXPORT ArrayScales
{
public:
  /// Sets the surfaces' colours.
  void Update(const std::vector<std::unique_ptr<SurfaceInSpace>>& surfaces);

  /// Of the array with a bar, the first by name; null and empty if no array is in use.
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
