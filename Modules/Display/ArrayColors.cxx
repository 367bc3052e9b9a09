#include "ArrayColors.h"

#include "RoundNumber.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
constexpr int HalfSteps = 128;
constexpr int ColorCount = 2 * HalfSteps + 1; // odd, so that zero has its own entry

// L*, a*, b* under D65 of RdBu's second outermost blue and red and of its centre.
using Lab = std::array<double, 3>;
constexpr Lab Blue{{42.47, 4.44, -43.42}};
constexpr Lab White{{97.23, 0.01, -0.01}};
constexpr Lab Red{{38.36, 58.66, 31.60}};

// sRGB of the colour at the fraction `share` from the centre: -1 for blue to 1 for red.
std::array<double, 3> ColorAt(double share)
{
  const Lab& end = share < 0.0 ? Blue : Red;
  Lab lab{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    lab[c] = White[c] + std::abs(share) * (end[c] - White[c]);
  }
  std::array<double, 3> rgb{};
  vtkMath::LabToRGB(lab.data(), rgb.data());
  return rgb;
}
} // namespace

vtkSmartPointer<vtkLookupTable> MakeArrayColors(double low, double high)
{
  const double limit =
      RoundNumberAbove(std::max(-low, high), {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0});
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetRange(low < 0.0 ? -limit : 0.0, high > 0.0 ? limit : 0.0);
  table->SetNumberOfTableValues(ColorCount);
  table->SetNanColor(0.5, 0.5, 0.5, 1.0);
  const double* range = table->GetRange();
  for (int c = 0; c < ColorCount; ++c)
  {
    const double number = range[0] + (range[1] - range[0]) * c / (ColorCount - 1);
    const auto color = ColorAt(std::round(number / limit * HalfSteps) / HalfSteps);
    table->SetTableValue(c, color[0], color[1], color[2]);
  }
  return table;
}

std::array<std::uint8_t, 3> ColorOf(vtkLookupTable* colors, double number)
{
  if (!std::isfinite(number))
  {
    return {{128, 128, 128}};
  }
  const double* range = colors->GetRange();
  const unsigned char* color = colors->MapValue(std::clamp(number, range[0], range[1]));
  return {{color[0], color[1], color[2]}};
}

std::string ArrayTitle(const std::string& array)
{
  static const std::map<std::string, std::string> Titles{
      {"DistanceToSurface", "Distance to the surface, mm"},
      {"Residual", "Residual of the fit, mm"},
      {"RadiusDeviation", "Uncertainty of the radius, mm"},
      {"NormalDeviation", "Uncertainty along the normal, mm"},
      {"SignedDistance", "Distance from the start, mm"},
      {"StandardDeviation", "Standard deviation, mm"},
      {"NoticedStiffness", "Stiffness felt, noticeable steps"}};
  const auto title = Titles.find(array);
  return title == Titles.end() ? array : title->second;
}
} // namespace palpate
