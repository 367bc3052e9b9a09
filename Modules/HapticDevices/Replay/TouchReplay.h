#pragma once

#include "TouchRecording.h"
#include "TouchScene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace palpate
{
/// Comparison of recomputed with recorded forces.
struct ReplayComparison
{
  std::uint64_t Ticks = 0;
  std::uint64_t DifferentTicks = 0;  ///< with any different bit in force, contact or safety
  std::int64_t FirstDifference = -1; ///< number of the first such tick; -1 if there is none
  double LargestDifference = 0.0;    ///< N, of the forces; NaN if one of them is
};

/// Repeats what other threads did until a tick, such as editing what is drilled.
using BeforeReplayedTick = std::function<void(const TouchState& recorded)>;

/// Feels a recorded session again, tick by tick at the recorded times: the same build gives the
/// same bits, and another one shows what it changed. `scenes` are those that the servo took over,
/// in their order. Fails where there are fewer scenes, or where one cannot be felt.
Status ReplayTouch(const std::shared_ptr<const TouchRecording>& recording,
                   const std::vector<std::shared_ptr<const TouchScene>>& scenes,
                   ReplayComparison& comparison, const BeforeReplayedTick& beforeTick = {});
} // namespace palpate
