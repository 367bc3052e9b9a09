#pragma once

#include "PalpateDisplayModule.h"

#include <array>

namespace palpate
{
/// How a volume is drawn as a whole, not by slices. Values are shares of its window.
enum class VolumePreset
{
  Bone,            ///< of CT: ivory, opaque from the middle of the window
  SoftTissue,      ///< of CT: skin to muscle, translucent
  Magnetic,        ///< of MR: grey, translucent
  MaximumIntensity ///< the brightest value on each line of sight
};
constexpr std::array<VolumePreset, 4> AllVolumePresets{
    {VolumePreset::Bone, VolumePreset::SoftTissue, VolumePreset::Magnetic,
     VolumePreset::MaximumIntensity}};

/// "CT: bone", "CT: soft tissue", "MR", "maximum intensity".
PALPATEDISPLAY_EXPORT const char* NameOf(VolumePreset preset);

/// Colour (sRGB) and opacity at a share of the window: 0 at its low end, 1 at its high end.
struct VolumeShade
{
  double Share;
  std::array<double, 3> Color;
  double Opacity; ///< of 1/150 of the volume's diagonal; of a maximum, of itself
};

/// In the order of their shares; in between, linear; beyond the ends as at them.
PALPATEDISPLAY_EXPORT const std::array<VolumeShade, 4>& ShadesOf(VolumePreset preset);
} // namespace palpate
