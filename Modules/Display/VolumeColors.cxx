#include "VolumeColors.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
using Rgb = std::array<double, 3>;

// Cividis from (0, 32, 76) to (255, 233, 69), with even steps of lightness.
Rgb BlueToYellowAt(double share)
{
  const std::array<Rgb, 2> ends{
      {{{0.0, 32.0 / 255.0, 76.0 / 255.0}}, {{1.0, 233.0 / 255.0, 69.0 / 255.0}}}};
  std::array<Rgb, 2> lab{};
  for (std::size_t e = 0; e < ends.size(); ++e)
  {
    vtkMath::RGBToLab(ends[e].data(), lab[e].data());
  }
  Rgb mixed{};
  for (std::size_t c = 0; c < mixed.size(); ++c)
  {
    mixed[c] = lab[0][c] + share * (lab[1][c] - lab[0][c]);
  }
  Rgb rgb{};
  vtkMath::LabToRGB(mixed.data(), rgb.data());
  return rgb;
}

Rgb ColorAt(VolumeColors colors, double share)
{
  switch (colors)
  {
  case VolumeColors::Hot:
    return {{3.0 * share, 3.0 * share - 1.0, 3.0 * share - 2.0}};
  case VolumeColors::BlueToYellow:
    return BlueToYellowAt(share);
  case VolumeColors::Red:
    return {{share, 0.0, 0.0}};
  case VolumeColors::Green:
    return {{0.0, share, 0.0}};
  case VolumeColors::Blue:
    return {{0.0, 0.0, share}};
  case VolumeColors::Grey:
    break;
  }
  return {{share, share, share}};
}

ColorTable MakeTable(VolumeColors colors)
{
  ColorTable table{};
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const Rgb color = ColorAt(colors, static_cast<double>(i) / (table.size() - 1.0));
    std::transform(
        color.begin(), color.end(), table[i].begin(),
        [](double part)
        { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(part, 0.0, 1.0))); });
  }
  return table;
}
} // namespace

const char* NameOf(VolumeColors colors)
{
  switch (colors)
  {
  case VolumeColors::Hot:
    return "hot";
  case VolumeColors::BlueToYellow:
    return "blue to yellow";
  case VolumeColors::Red:
    return "red";
  case VolumeColors::Green:
    return "green";
  case VolumeColors::Blue:
    return "blue";
  case VolumeColors::Grey:
    break;
  }
  return "grey";
}

const ColorTable& TableOf(VolumeColors colors)
{
  static const std::array<ColorTable, AllVolumeColors.size()> tables = []
  {
    std::array<ColorTable, AllVolumeColors.size()> made{};
    std::transform(AllVolumeColors.begin(), AllVolumeColors.end(), made.begin(), MakeTable);
    return made;
  }();
  return tables.at(static_cast<std::size_t>(colors));
}
} // namespace palpate
