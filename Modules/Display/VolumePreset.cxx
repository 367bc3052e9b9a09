#include "VolumePreset.h"

#include <cstddef>

namespace palpate
{
namespace
{
using Shades = std::array<VolumeShade, 4>;

constexpr std::array<const char*, 4> Names{"CT: bone", "CT: soft tissue", "MR",
                                           "maximum intensity"};
constexpr std::array<Shades, 4> All{{Shades{{{0.0, {{0.45, 0.2, 0.15}}, 0.0},
                                             {0.25, {{0.7, 0.45, 0.3}}, 0.0},
                                             {0.5, {{0.95, 0.88, 0.72}}, 0.45},
                                             {1.0, {{1.0, 0.98, 0.92}}, 0.9}}},
                                     Shades{{{0.05, {{0.6, 0.35, 0.25}}, 0.0},
                                             {0.2, {{0.9, 0.68, 0.52}}, 0.25},
                                             {0.6, {{0.8, 0.35, 0.28}}, 0.35},
                                             {1.0, {{1.0, 0.92, 0.82}}, 0.6}}},
                                     Shades{{{0.0, {{0.3, 0.3, 0.3}}, 0.0},
                                             {0.2, {{0.5, 0.5, 0.5}}, 0.0},
                                             {0.6, {{0.9, 0.9, 0.9}}, 0.2},
                                             {1.0, {{1.0, 1.0, 1.0}}, 0.6}}},
                                     Shades{{{0.0, {{0.0, 0.0, 0.0}}, 0.0},
                                             {0.05, {{0.05, 0.05, 0.05}}, 0.2},
                                             {0.4, {{0.4, 0.4, 0.4}}, 0.8},
                                             {1.0, {{1.0, 1.0, 1.0}}, 1.0}}}}};
} // namespace

const char* NameOf(VolumePreset preset)
{
  return Names.at(static_cast<std::size_t>(preset));
}

const std::array<VolumeShade, 4>& ShadesOf(VolumePreset preset)
{
  return All.at(static_cast<std::size_t>(preset));
}
} // namespace palpate
