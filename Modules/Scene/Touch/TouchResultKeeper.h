#pragma once

#include "TouchRun.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Collects the ticks of a touch into its result, in memory that does not grow.
class TouchResultKeeper
{
public:
  /// Keeps the address of the result, which must outlive it.
  TouchResultKeeper(TouchResult& result, std::size_t structures);

  /// The next tick, that took `microseconds` to compute; 0 where that is not known.
  void Add(const TouchState& state, float microseconds);
  /// After the last tick.
  void Close();

private:
  void Trace(const TouchState& state, float microseconds);

  TouchResult& Result;
  std::int64_t Start = 0; // ns
  std::int64_t Last = 0;  // ns
};
} // namespace palpate
