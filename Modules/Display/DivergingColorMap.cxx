#include "DivergingColorMap.h"

#include "RoundNumber.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace palpate
{
namespace
{
// L*, a*, b* under D65 of RdBu's second outermost blue and red and of its centre.
using Lab = std::array<double, 3>;
constexpr Lab Blue{{42.47, 4.44, -43.42}};
constexpr Lab White{{97.23, 0.01, -0.01}};
constexpr Lab Red{{38.36, 58.66, 31.60}};
constexpr std::array<std::uint8_t, 3> Grey{{128, 128, 128}};

// sRGB 0..255 of the colour at the fraction `share` from the centre to an end.
std::array<std::uint8_t, 3> ColorTowards(const Lab& end, double share)
{
  double lab[3];
  double rgb[3];
  for (std::size_t c = 0; c < 3; ++c)
  {
    lab[c] = White[c] + share * (end[c] - White[c]);
  }
  vtkMath::LabToRGB(lab, rgb);
  std::array<std::uint8_t, 3> color{};
  std::transform(std::begin(rgb), std::end(rgb), color.begin(),
                 [](double c) { return static_cast<std::uint8_t>(std::lround(255.0 * c)); });
  return color;
}
} // namespace

DivergingColorMap::DivergingColorMap(double limit) : Range(limit)
{
  for (int step = -HalfSteps; step <= HalfSteps; ++step)
  {
    const double share = std::abs(step) / static_cast<double>(HalfSteps);
    this->Table[static_cast<std::size_t>(step + HalfSteps)] =
        ColorTowards(step < 0 ? Blue : Red, share);
  }
}

double DivergingColorMap::RoundLimit(double size)
{
  return RoundNumberAbove(size, {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0});
}

std::array<std::uint8_t, 3> DivergingColorMap::ColorOf(double number) const
{
  if (!std::isfinite(number))
  {
    return Grey;
  }
  const double share = std::clamp(number / this->Range, -1.0, 1.0);
  return this->Table[static_cast<std::size_t>(std::lround(share * HalfSteps) + HalfSteps)];
}
} // namespace palpate
