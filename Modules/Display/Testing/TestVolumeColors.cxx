#include "VolumeColors.h"

#include "vtkMath.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace palpate::volume_colors_test
{
namespace
{
double LightnessOf(const std::array<std::uint8_t, 3>& color)
{
  double lab[3];
  vtkMath::RGBToLab(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, lab, lab + 1, lab + 2);
  return lab[0];
}

TEST(VolumeColors, GreyIsTheEntry)
{
  const ColorTable& table = TableOf(VolumeColors::Grey);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const auto grey = static_cast<std::uint8_t>(i);
    EXPECT_EQ(table[i], (std::array<std::uint8_t, 3>{{grey, grey, grey}}));
  }
}

TEST(VolumeColors, HigherValuesAreLighter)
{
  for (const VolumeColors colors : AllVolumeColors)
  {
    const ColorTable& table = TableOf(colors);
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      // Rounding to 8 bits changes a colour's lightness by at most half a unit.
      EXPECT_GE(LightnessOf(table[i]), LightnessOf(table[i - 1]) - 0.5) << NameOf(colors) << i;
    }
    EXPECT_GE(LightnessOf(table[255]), LightnessOf(table[0]) + 30.0) << NameOf(colors);
  }
}

TEST(VolumeColors, BlueToYellowIsEvenInLightness)
{
  const ColorTable& table = TableOf(VolumeColors::BlueToYellow);
  EXPECT_EQ(table[0], (std::array<std::uint8_t, 3>{{0, 32, 76}}));
  EXPECT_EQ(table[255], (std::array<std::uint8_t, 3>{{255, 233, 69}}));
  const double middle = 0.5 * (LightnessOf(table[0]) + LightnessOf(table[255]));
  // The colours between may be outside of sRGB, where they are clipped.
  EXPECT_NEAR(LightnessOf(table[128]), middle, 2.0);
}

TEST(VolumeColors, HaveNamesOfTheirOwn)
{
  std::set<std::string> names;
  for (const VolumeColors colors : AllVolumeColors)
  {
    names.insert(NameOf(colors));
  }
  EXPECT_EQ(names.size(), AllVolumeColors.size());
}
} // namespace
} // namespace palpate::volume_colors_test
