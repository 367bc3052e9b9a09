#pragma once

#include "TouchRun.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Accumulates the ticks of a touch into its result, in bounded memory.
class TouchResultCollector
{
public:
  /// Keeps the address of the result, which must outlive this object.
  TouchResultCollector(TouchResult& result, std::size_t structures);

  /// Adds the next tick, which took `microseconds` to compute; 0 if unknown.
  void Add(const TouchState& state, float microseconds);
  /// Call after the last tick.
  void Close();

private:
  void Trace(const TouchState& state, float microseconds);

  TouchResult& Result;
  std::int64_t Start = 0; // ns
  std::int64_t Last = 0;  // ns
};
} // namespace palpate
