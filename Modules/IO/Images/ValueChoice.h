#pragma once

#include <optional>
#include <vector>

namespace palpate
{
/// Which values of an image count, for those that are no labels as they are.
struct ValueChoice
{
  /// The voxels from this value on become label 1, all others, and NaN, 0: for probability maps.
  std::optional<double> Threshold;
  /// Values that become 0; NaN stands for every value that is not finite.
  std::vector<double> Background;
};
} // namespace palpate
