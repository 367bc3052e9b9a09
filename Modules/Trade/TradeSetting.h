#pragma once

#include "PalpateTradeModule.h"
#include "SceneSettings.h"

#include <array>
#include <string>

namespace palpate
{
/// One value of every knob by which a structure is felt, or drawn. Knobs that a representation does
/// not have stay at their defaults.
struct TradeSetting
{
  TouchRepresentation Representation = TouchRepresentation::SubVoxel; ///< never Automatic
  int Degree = 12;                                                    ///< of harmonics
  HarmonicContactMode Mode = HarmonicContactMode::Nearest;            ///< of harmonics
  int Facets = 0; ///< about so many; 0: as many as the surface has
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear; ///< of a field
  /// Of the tool's shell at a field; 0: as voxels and radius ask for.
  int ToolPoints = 26;
  /// Of the icosahedron that harmonics are drawn over; 0: the setting is felt, and not drawn.
  int DrawnFrequency = 0;
};

PALPATETRADE_EXPORT bool operator==(const TradeSetting& a, const TradeSetting& b);

/// "harmonics of degree 12, nearest point".
PALPATETRADE_EXPORT std::string Describe(const TradeSetting& setting);

/// The same as short text that stays the same from version to version: "harmonics/12/nearest".
PALPATETRADE_EXPORT std::string KeyOf(const TradeSetting& setting);

/// What a measured setting differs in from its representation's default.
enum class TradeKnob
{
  Representation, ///< in nothing: it is the default
  Degree,
  Mode,
  Facets,
  Interpolation,
  ToolPoints,
  Drawing
};

/// The words of files and options for a TradeKnob, in the order of its enumerators.
inline constexpr std::array<const char*, 7> TradeKnobWords{
    {"representation", "degree", "mode", "facets", "interpolation", "tool-points", "drawing"}};
} // namespace palpate
