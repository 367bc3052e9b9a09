#pragma once

#include "PalpateDisplayModule.h"

#include <array>
#include <cstdint>

namespace palpate
{
/// Colours for the grey values of a volume, dark to bright.
enum class VolumeColors
{
  Grey,
  Hot,          ///< black, red, yellow, white
  BlueToYellow, ///< even in lightness, and for colour-blind viewers
  Red,
  Green,
  Blue
};
constexpr std::array<VolumeColors, 6> AllVolumeColors{
    {VolumeColors::Grey, VolumeColors::Hot, VolumeColors::BlueToYellow, VolumeColors::Red,
     VolumeColors::Green, VolumeColors::Blue}};

/// "grey", "hot", "blue to yellow", ...
PALPATEDISPLAY_EXPORT const char* NameOf(VolumeColors colors);

/// sRGB from black (entry 0) to white (255) of a window.
using ColorTable = std::array<std::array<std::uint8_t, 3>, 256>;

/// Linear in CIELAB between the ends of cividis (Nunez, Anderton and Renslow, PLoS ONE 13, 2018)
/// for blue to yellow; the others are linear in sRGB.
PALPATEDISPLAY_EXPORT const ColorTable& TableOf(VolumeColors colors);
} // namespace palpate
