#include "ParameterColors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr double CellAngle = M_PI / 6.0;
constexpr double DarkShare = 0.72;
// By the signs of x, y and z (bits 1, 2 and 4, set if positive).
constexpr std::array<SoftwareRenderer::Color, 8> Octants{{{0, 158, 115},
                                                          {0, 114, 178},
                                                          {204, 121, 167},
                                                          {140, 140, 140},
                                                          {240, 228, 66},
                                                          {213, 94, 0},
                                                          {86, 180, 233},
                                                          {230, 159, 0}}};
} // namespace

SoftwareRenderer::Color ParameterColor(const Vector3& direction)
{
  const std::size_t octant = (direction[0] > 0.0 ? 1U : 0U) + (direction[1] > 0.0 ? 2U : 0U) +
                             (direction[2] > 0.0 ? 4U : 0U);
  const double longitude = std::atan2(direction[1], direction[0]) + M_PI;
  const double latitude = std::asin(std::clamp(direction[2], -1.0, 1.0)) + M_PI;
  const auto cell =
      static_cast<int>(longitude / CellAngle) + static_cast<int>(latitude / CellAngle);
  SoftwareRenderer::Color color = Octants[octant];
  for (std::uint8_t& channel : color)
  {
    channel = cell % 2 == 0 ? channel : static_cast<std::uint8_t>(std::lround(DarkShare * channel));
  }
  return color;
}
} // namespace palpate
