#pragma once

#include <functional>

namespace palpate
{
/// Receives the fraction done, 0 to 1, on the caller's thread; returns false to cancel. A cancelled
/// kernel returns a failure, whose message is for developers only.
using KernelProgress = std::function<bool(double fraction)>;

/// For a step that is the part [from, to] of a kernel. `progress`, which may be empty, has to
/// outlive it.
inline KernelProgress PartOf(const KernelProgress& progress, double from, double to)
{
  if (!progress)
  {
    return {};
  }
  return [&progress, from, to](double fraction) { return progress(from + (to - from) * fraction); };
}
} // namespace palpate
