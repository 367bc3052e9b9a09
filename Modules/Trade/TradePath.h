#pragma once

#include "PalpateTradeModule.h"
#include "TradeReference.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// How a tool is led over a structure.
struct TradePathSettings
{
  std::uint64_t Seed = 1; ///< equal seeds lead the same way
  double Seconds = 10.0;  ///< at least, of touch and what is round it
  double MostDepth = 2.0; ///< mm below the surface; less on a structure that is thinner
};

/// A tool's way over a structure, a place a tick of 1 ms, and where its proxy truly is meanwhile.
/// It is made by the reference alone, so it is the same for all that is compared.
struct TradePath
{
  struct Tick
  {
    Vector3 ProbeWorld; ///< mm
    TradeTruth Truth;
  };

  static constexpr double Period = 1e-3; ///< s

  std::vector<Tick> Ticks;
  /// The first tick of each stroke: free, outside the structure, unconnected with the one before.
  std::vector<std::size_t> Strokes;
  double MostDepth = 0.0; ///< mm that was aimed at
};

/// Strokes from all round: towards the structure, in to some depth, along its surface at 20 to 100
/// mm/s with a direction that wanders, and out again. Throws InputError where nothing is met, and
/// Cancelled.
PALPATETRADE_EXPORT TradePath MakeTradePath(TradeReference& reference,
                                            const TouchToolSettings& tool,
                                            const TradePathSettings& settings,
                                            const ProgressFunction& progress);
} // namespace palpate
