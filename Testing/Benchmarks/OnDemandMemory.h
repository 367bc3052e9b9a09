#pragma once

#include "BrickLayout.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::bench
{
/// The bone of a head's CT of 512^3 voxels, stroked by a ball of 2 mm at 90 mm/s, whole or within a
/// budget.
struct OnDemandRow
{
  FieldInterpolation Interpolation;
  std::optional<double> BudgetMegabytes;
  std::uintmax_t Bytes;     ///< of what the structure is felt by
  double ResidentMebibytes; ///< by which the process grew for it
  double MakeSeconds;
  double TickMicroseconds; ///< median
  std::uint64_t Ticks;
  std::uint64_t DifferentTicks; ///< in any bit, from those of the whole field on the same path
  double LargestDifference;     ///< N
  std::uint64_t CoarseTicks;
  std::uint64_t Versions; ///< made in that touch
  std::uint64_t Reads;    ///< bricks that were read for them
};

/// A minute and 2 GB. Throws std::runtime_error where a scene cannot be made.
std::vector<OnDemandRow> MeasureOnDemand();
} // namespace palpate::bench
