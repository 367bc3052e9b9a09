#pragma once

#include "PalpateDisplayModule.h"

#include <array>
#include <cstdint>

namespace palpate
{
/// Colours for signed numbers: blue below zero, nearly white at zero, red above. Blue and red are
/// distinguishable for colour-blind viewers, and lightness decreases evenly to both sides. Linear
/// interpolation in CIELAB between the ends and the centre of ColorBrewer's RdBu scheme (Harrower
/// and Brewer, The Cartographic Journal 40, 2003).
class PALPATEDISPLAY_EXPORT DivergingColorMap
{
public:
  /// The range is -limit to limit; numbers beyond it get the colours of the ends.
  explicit DivergingColorMap(double limit);

  /// The smallest convenient limit for a colour bar (1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of
  /// ten) that is at least `size`; 1 if `size` is not a positive number.
  static double RoundLimit(double size);

  double Limit() const { return this->Range; }
  /// sRGB; grey for a number that is not finite.
  std::array<std::uint8_t, 3> ColorOf(double number) const;

private:
  static constexpr int HalfSteps = 128;

  double Range;
  std::array<std::array<std::uint8_t, 3>, 2 * HalfSteps + 1> Table{};
};
} // namespace palpate
