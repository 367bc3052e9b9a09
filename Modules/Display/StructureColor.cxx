#include "StructureColor.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
using Rgb = std::array<double, 3>;

// The largest channel of what cannot be told from black when shaded.
constexpr double NearlyBlack = 0.2;

// Okabe and Ito's palette (Color Universal Design, 2008) without black.
constexpr std::array<Rgb, 7> ColorBlindPalette{{{{0.90, 0.60, 0.00}},
                                                {{0.34, 0.71, 0.91}},
                                                {{0.00, 0.62, 0.45}},
                                                {{0.94, 0.89, 0.26}},
                                                {{0.00, 0.45, 0.70}},
                                                {{0.84, 0.37, 0.00}},
                                                {{0.80, 0.47, 0.65}}}};
constexpr std::size_t ShadeCount = 3;

Rgb BlendTo(const Rgb& color, double share, double to)
{
  Rgb blended{};
  std::transform(color.begin(), color.end(), blended.begin(),
                 [=](double part) { return (1.0 - share) * part + share * to; });
  return blended;
}
} // namespace

std::array<double, 3> StructureColor(const std::array<double, 3>& ofFile, int id)
{
  if (*std::max_element(ofFile.begin(), ofFile.end()) > NearlyBlack)
  {
    return ofFile;
  }
  // The palette as it is, then lighter, then darker.
  const auto place = static_cast<std::size_t>(std::max(id, 1) - 1);
  const Rgb& hue = ColorBlindPalette[place % ColorBlindPalette.size()];
  switch (place / ColorBlindPalette.size() % ShadeCount)
  {
  case 0:
    return hue;
  case 1:
    return BlendTo(hue, 0.45, 1.0);
  default:
    return BlendTo(hue, 0.35, 0.0);
  }
}
} // namespace palpate
