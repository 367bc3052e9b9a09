#include "CieLabColor.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Inverse of the CIE 1976 lightness function.
double InverseLightness(double t) noexcept
{
  constexpr double Delta = 6.0 / 29.0;
  return t > Delta ? t * t * t : 3.0 * Delta * Delta * (t - 4.0 / 29.0);
}

// Transfer function of IEC 61966-2-1.
double Companded(double linear) noexcept
{
  const double value =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return std::clamp(value, 0.0, 1.0);
}
} // namespace

std::array<double, 3> CieLabToRgb(const std::array<std::uint16_t, 3>& encoded) noexcept
{
  const double lightness = encoded[0] / 65535.0 * 100.0;
  const double a = encoded[1] / 65535.0 * 255.0 - 128.0;
  const double b = encoded[2] / 65535.0 * 255.0 - 128.0;
  const double fy = (lightness + 16.0) / 116.0;
  const double x = 0.950456 * InverseLightness(fy + a / 500.0);
  const double y = InverseLightness(fy);
  const double z = 1.088754 * InverseLightness(fy - b / 200.0);
  // XYZ (D65) to linear sRGB, IEC 61966-2-1.
  return {{Companded(3.2406 * x - 1.5372 * y - 0.4986 * z),
           Companded(-0.9689 * x + 1.8758 * y + 0.0415 * z),
           Companded(0.0557 * x - 0.2040 * y + 1.0570 * z)}};
}
} // namespace palpate
