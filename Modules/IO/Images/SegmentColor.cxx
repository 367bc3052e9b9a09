#include "SegmentColor.h"

#include "Segmentation.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
std::array<double, 3> DefaultSegmentColor(int label)
{
  std::array<double, 3> color = Segment().Color;
  if (label != 1)
  {
    constexpr double GoldenSection = 0.6180339887498949;
    const double hue = std::fmod(label * GoldenSection, 1.0);
    vtkMath::HSVToRGB(hue, 0.55, 0.9, &color[0], &color[1], &color[2]);
  }
  return color;
}

std::array<double, 3> CieLabToRgb(const std::array<std::uint16_t, 3>& encoded) noexcept
{
  const double lab[3] = {encoded[0] / 65535.0 * 100.0, encoded[1] / 65535.0 * 255.0 - 128.0,
                         encoded[2] / 65535.0 * 255.0 - 128.0};
  std::array<double, 3> rgb{};
  vtkMath::LabToRGB(lab, rgb.data());
  std::transform(rgb.begin(), rgb.end(), rgb.begin(),
                 [](double part) { return std::clamp(part, 0.0, 1.0); });
  return rgb;
}

std::array<std::uint16_t, 3> RgbToCieLab(const std::array<double, 3>& rgb) noexcept
{
  double lab[3];
  vtkMath::RGBToLab(rgb.data(), lab);
  const auto encoded = [](double share)
  { return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535.0)); };
  return {encoded(lab[0] / 100.0), encoded((lab[1] + 128.0) / 255.0),
          encoded((lab[2] + 128.0) / 255.0)};
}
} // namespace palpate
