#pragma once

#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Minimum and maximum.
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

/// An interval of consecutive ticks.
struct TouchStretch
{
  double Time = 0.0;        ///< s from the very first tick to the first of these
  LeastAndMost Force;       ///< N, applied
  LeastAndMost Torque;      ///< N mm, applied
  LeastAndMost Depth;       ///< mm, of the deepest contact
  LeastAndMost Period;      ///< us, from the tick before
  LeastAndMost Computation; ///< us that ticks took, in virtual time; else 0
};

/// A single tick. `start` and `last` (ns): when the first tick was due, and when the previous one
/// began.
PALPATESCENE_EXPORT TouchStretch StretchOf(const TouchState& state, std::int64_t start,
                                           std::int64_t last);

/// Trace of a touch in bounded memory: an interval holds one tick until there are MostStretches,
/// then two, four and so on, so that no single-tick peak is lost. Recordings hold every tick.
class PALPATESCENE_EXPORT TouchTrace
{
public:
  /// Even. At 1 kHz, one tick each for the first 16 s.
  static constexpr std::size_t MostStretches = 16384;

  /// Adds the next tick, as an interval of one.
  void Add(const TouchStretch& tick);

  const std::vector<TouchStretch>& Stretches() const noexcept { return this->List; }
  /// Ticks in each interval, except the last.
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
