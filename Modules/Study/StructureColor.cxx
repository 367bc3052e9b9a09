#include "StructureColor.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
using Color = std::array<double, 3>;

constexpr double Black = 0.2; // the largest channel of what cannot be told from black when shaded

// Okabe and Ito's palette (Color Universal Design, 2008) without black.
constexpr std::array<Color, 7> Palette{{{{0.90, 0.60, 0.00}},
                                        {{0.34, 0.71, 0.91}},
                                        {{0.00, 0.62, 0.45}},
                                        {{0.94, 0.89, 0.26}},
                                        {{0.00, 0.45, 0.70}},
                                        {{0.84, 0.37, 0.00}},
                                        {{0.80, 0.47, 0.65}}}};
constexpr std::size_t Shades = 3;

Color Blend(const Color& color, double share, double to)
{
  Color blended{};
  std::transform(color.begin(), color.end(), blended.begin(),
                 [=](double part) { return (1.0 - share) * part + share * to; });
  return blended;
}
} // namespace

std::array<double, 3> StructureColor(const std::array<double, 3>& ofFile, int id)
{
  if (*std::max_element(ofFile.begin(), ofFile.end()) > Black)
  {
    return ofFile;
  }
  // The palette as it is, then lighter, then darker.
  const auto place = static_cast<std::size_t>(std::max(id, 1) - 1);
  const Color& hue = Palette[place % Palette.size()];
  switch (place / Palette.size() % Shades)
  {
  case 0:
    return hue;
  case 1:
    return Blend(hue, 0.45, 1.0);
  default:
    return Blend(hue, 0.35, 0.0);
  }
}
} // namespace palpate
