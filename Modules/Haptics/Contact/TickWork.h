#pragma once

#include <algorithm>

namespace palpate
{
/// The work of a tracker in one tick, in evaluations of a surface with two derivatives and the
/// bounds that they lead to. It is counted, not timed, so that a recording replays bit for bit.
/// Where it ends, the proxy stays at the last proven place and goes on in the next tick.
struct TickWork
{
  /// An evaluation of degree L takes at most 0.5 µs (L + 17)^2 / 33^2 ..., so that a tick takes
  /// less than half a millisecond.
  static constexpr int Evaluations(int degree) noexcept
  {
    constexpr int Most = 1000;
    constexpr int Least = 100;
    return std::clamp(Most * 17 * 17 / ((degree + 1) * (degree + 1)), Least, Most);
  }
};
} // namespace palpate
