#pragma once

#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The least and the largest of some numbers.
struct LeastAndMost
{
  float Least = 0.0F;
  float Most = 0.0F;

  void Join(const LeastAndMost& other) noexcept
  {
    this->Least = std::min(this->Least, other.Least);
    this->Most = std::max(this->Most, other.Most);
  }
};

/// Some ticks that follow each other.
struct TouchStretch
{
  double Time = 0.0;        ///< s from the first tick of all to the first of these
  LeastAndMost Force;       ///< N, applied
  LeastAndMost Depth;       ///< mm, of the deepest contact
  LeastAndMost Period;      ///< us, from the tick before
  LeastAndMost Computation; ///< us that ticks took, where time is virtual; else 0
};

/// A tick alone. `start` and `last` (ns): when the first tick was due, and when the one before this
/// began.
PALPATESCENE_EXPORT TouchStretch StretchOf(const TouchState& state, std::int64_t start,
                                           std::int64_t last);

/// What was felt over time, in memory that does not grow: a stretch holds one tick until there are
/// MostStretches, then two, and so on, so that no peak of a tick is lost. All ticks are in a
/// recording.
class PALPATESCENE_EXPORT TouchTrace
{
public:
  /// Even. At 1 kHz every tick of the first 16 s.
  static constexpr std::size_t MostStretches = 16384;

  /// The next tick, as a stretch of one.
  void Add(const TouchStretch& tick);

  const std::vector<TouchStretch>& Stretches() const noexcept { return this->List; }
  /// So many in each but the last.
  std::uint64_t TicksAStretch() const noexcept { return this->Length; }
  /// Of all ticks.
  const TouchStretch& Whole() const noexcept { return this->All; }
  double Duration() const noexcept { return this->LastTime; } ///< s, to the last tick

private:
  void Halve();

  std::vector<TouchStretch> List;
  TouchStretch All;
  std::uint64_t Length = 1;
  std::uint64_t TicksInLast = 0;
  double LastTime = 0.0;
};
} // namespace palpate
