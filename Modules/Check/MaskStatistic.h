#pragma once

#include "Vector3.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A number that tells clean masks from wrong ones, the larger the more suspicious, and where it
/// comes from.
struct MaskStatistic
{
  std::string Key; ///< "hole", "end_superior"; see CheckRules
  double Value = 0.0;
  Vector3 Place = Vector3::Zero(); ///< world, mm
  double Amount = 0.0;             ///< for the sentence, in the rule's unit
  /// The name of the other structure that it concerns; empty if there is none where it was looked
  /// for.
  std::optional<std::string> Other = {};
};

using MaskStatistics = std::vector<MaskStatistic>;
} // namespace palpate
