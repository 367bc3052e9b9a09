#pragma once

#include "ReducedCompliance.h"
#include "Status.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// A reduced compliance in a quarter of its memory, for pictures: the root of each diagonal entry,
/// and each entry C_ij below the diagonal as a whole number of thousandths of sqrt(C_ii C_jj).
struct PackedCompliance
{
  static constexpr int Whole = 1000; ///< thousandths in one

  int Degree = -1;                    ///< -1: there is none
  std::vector<double> Roots;          ///< of the diagonal, 3 (Degree + 1)^2, positive
  std::vector<std::int16_t> Relative; ///< row by row, within -Whole and Whole

  /// Up to `degree`, or the compliance's own if that is lower.
  static PackedCompliance Of(const ReducedCompliance& compliance, int degree);
  /// Symmetric, its diagonal exact.
  ReducedCompliance Unpacked() const;

  bool IsEmpty() const noexcept { return this->Degree < 0; }
  /// Fails for one that is incomplete or has entries outside of the limits. For files.
  Status Check() const;
};
} // namespace palpate
