#include "ArrayColors.h"

#include "DivergingColorMap.h"

#include "vtkLookupTable.h"

#include <algorithm>
#include <map>

namespace palpate
{
namespace
{
constexpr int ColorCount = 257; // odd, so that zero has its own entry
} // namespace

vtkSmartPointer<vtkLookupTable> MakeArrayColors(double low, double high)
{
  const double limit = DivergingColorMap::RoundLimit(std::max(-low, high));
  const DivergingColorMap colors(limit);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetRange(low < 0.0 ? -limit : 0.0, high > 0.0 ? limit : 0.0);
  table->SetNumberOfTableValues(ColorCount);
  const double* range = table->GetRange();
  for (int c = 0; c < ColorCount; ++c)
  {
    const auto color = colors.ColorOf(range[0] + (range[1] - range[0]) * c / (ColorCount - 1));
    table->SetTableValue(c, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  }
  return table;
}

std::string ArrayTitle(const std::string& array)
{
  static const std::map<std::string, std::string> Titles{
      {"DistanceToSurface", "Distance to the surface, mm"},
      {"Residual", "Residual of the fit, mm"},
      {"RadiusDeviation", "Uncertainty of the radius, mm"}};
  const auto title = Titles.find(array);
  return title == Titles.end() ? array : title->second;
}
} // namespace palpate
