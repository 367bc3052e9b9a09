#pragma once

#include "CheckRule.h"

#include <limits>
#include <vector>

namespace palpate
{
/// How rare a value is among those of clean masks.
///
/// Among them it is a rank: (1 + values at least as large) / (1 + values). Beyond the largest one
/// the probability falls exponentially on the rule's scale: by e for each mean excess of the values
/// over their 80 % quantile (Davison and Smith, J. Royal Statistical Society B 52, 1990), or for
/// what the rule has at least, since among masks without any hole a single voxel is no proof. On
/// the bounded scale, where a few odd masks that somebody called clean may reach the bound, it
/// begins to fall at the 97 % quantile. Calibration does not rely on the exponential: scores of
/// left-out cases use it, too.
class TailProbability
{
public:
  TailProbability() = default;
  /// Values in any order.
  TailProbability(std::vector<double> values, const CheckRule& rule);

  static constexpr double Without = std::numeric_limits<double>::quiet_NaN();

  /// Of a value. `without`, if it is one of the values, does not count.
  double Of(double value, double without = Without) const;
  const std::vector<double>& Sorted() const noexcept { return this->Values; }

private:
  double Scaled(double value) const;

  std::vector<double> Values;
  TailScale On = TailScale::Square;
  double LeastTail = 1.0;
};
} // namespace palpate
