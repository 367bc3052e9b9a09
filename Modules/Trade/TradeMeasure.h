#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "TradePath.h"
#include "TradeRow.h"

namespace palpate
{
/// Settings of touch during a measurement.
struct TradeTouch
{
  TouchToolSettings Tool;
  double Stiffness = 0.5; ///< N/mm
  int Runs = 5;           ///< a tick's time is the minimum over this many runs of the same path
};

/// Follows `path` as a servo does and fills in the times, errors and jumps of `row`. Without
/// friction and damping, so that only the representation matters. Ticks with an unknown reference
/// position, or without contact in both, count only in the times. Throws InputError if the tool
/// cannot touch the model, and Cancelled.
PALPATETRADE_EXPORT void MeasureTouch(const ContactModel& model, const TradeTouch& touch,
                                      const TradePath& path, const Clock& clock, TradeRow& row,
                                      const ProgressFunction& progress);
} // namespace palpate
