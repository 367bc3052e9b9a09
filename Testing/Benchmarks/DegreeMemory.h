#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::bench
{
/// Models of degree 12 of mricron's atlas, all touched, stroked by a ball of 2 mm at 90 mm/s, all
/// in memory or within a budget.
struct DegreeRow
{
  int Structures;
  std::optional<double> BudgetMegabytes;
  std::uintmax_t KeptBytes; ///< of models, coarse bodies and their trackers
  std::uintmax_t MostBytes; ///< of models and their trackers beside that, at most at once
  double ResidentMebibytes; ///< by which the process grew for scene and stroke
  std::uint64_t Ticks;
  std::uint64_t DifferentTicks; ///< in any bit, from those of all in memory on the same path
  std::uint64_t CoarseTicks;
  std::uint64_t Brought; ///< structures, in that stroke
};

/// A minute. None where the atlas is not installed. Throws std::runtime_error where a scene cannot
/// be made.
std::vector<DegreeRow> MeasureDegrees();
} // namespace palpate::bench
