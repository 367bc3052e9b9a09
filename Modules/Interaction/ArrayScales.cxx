#include "ArrayScales.h"

#include "ArrayColors.h"
#include "SurfaceInSpace.h"
#include "vtkSurfaceDisplay.h"

#include "vtkLookupTable.h"

#include <algorithm>
#include <utility>

namespace palpate
{
void ArrayScales::Update(const std::vector<std::unique_ptr<SurfaceInSpace>>& surfaces)
{
  std::map<std::string, Scale> next;
  for (const auto& surface : surfaces)
  {
    if (const auto range = surface->ColoredRange())
    {
      const auto place = next.try_emplace(surface->Display()->GetColorArray(), Scale{*range, {}});
      std::array<double, 2>& whole = place.first->second.Range;
      whole = {std::min(whole[0], (*range)[0]), std::max(whole[1], (*range)[1])};
    }
  }
  for (auto& [name, scale] : next)
  {
    const auto known = this->Scales.find(name);
    const bool isSame = known != this->Scales.end() && known->second.Range == scale.Range;
    scale.Colors = isSame ? known->second.Colors : MakeArrayColors(scale.Range[0], scale.Range[1]);
  }
  this->Scales = std::move(next);
  for (const auto& surface : surfaces)
  {
    if (surface->ColoredRange())
    {
      surface->SetColors(this->Scales.at(surface->Display()->GetColorArray()).Colors);
    }
  }
}

vtkLookupTable* ArrayScales::FirstColors() const
{
  return this->Scales.empty() ? nullptr : this->Scales.begin()->second.Colors.Get();
}

std::string ArrayScales::FirstArray() const
{
  return this->Scales.empty() ? std::string() : this->Scales.begin()->first;
}
} // namespace palpate
