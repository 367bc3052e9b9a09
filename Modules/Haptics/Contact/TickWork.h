#pragma once

#include <algorithm>

namespace palpate
{
/// The work of a tracker in one tick, in evaluations of a surface with two derivatives and the
/// bounds that they lead to. It is counted, not timed, so that a recording replays bit for bit.
/// Where it ends, the proxy stays at the last proven place and goes on in the next tick.
struct TickWork
{
  /// `most` is that of a surface of degree 16 or less; above, evaluations take longer, in
  /// proportion to the number of coefficients.
  static constexpr int Evaluations(int most, int degree) noexcept
  {
    constexpr int Least = 100;
    return std::clamp(most * 17 * 17 / ((degree + 1) * (degree + 1)), Least, most);
  }
};
} // namespace palpate
