#pragma once

#include "PalpateTradeModule.h"
#include "TradeReference.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Settings of a tool's path over a structure.
struct TradePathSettings
{
  std::uint64_t Seed = 1; ///< equal seeds give equal paths
  double Seconds = 10.0;  ///< minimum, including approach and retreat
  double MostDepth = 2.0; ///< mm below the surface; less on thin structures
};

/// A tool's path over a structure, one position per tick of 1 ms, with the reference position of
/// its proxy. Made by the reference alone, so it is the same for all settings.
struct TradePath
{
  struct Tick
  {
    Vector3 ProbeWorld; ///< mm
    TradePosition Truth;
  };

  static constexpr double Period = 1e-3; ///< s

  std::vector<Tick> Ticks;
  /// The first tick of each stroke: outside of the structure, not connected to the previous stroke.
  std::vector<std::size_t> Strokes;
  double MostDepth = 0.0; ///< mm, target depth

  /// End of the stroke that begins at Strokes[stroke].
  std::size_t EndOf(std::size_t stroke) const
  {
    return stroke + 1 < this->Strokes.size() ? this->Strokes[stroke + 1] : this->Ticks.size();
  }
};

/// Strokes from all sides: towards the structure, in to some depth, along its surface at 20 to 100
/// mm/s in a wandering direction, and out again. Throws InputError if no stroke meets the
/// structure, and Cancelled.
PALPATETRADE_EXPORT TradePath MakeTradePath(TradeReference& reference,
                                            const TouchToolSettings& tool,
                                            const TradePathSettings& settings,
                                            const ProgressFunction& progress);
} // namespace palpate
