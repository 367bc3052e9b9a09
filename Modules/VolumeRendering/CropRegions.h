#pragma once

#include "FieldGrid.h"
#include "HalfSpace.h"

#include <array>

namespace palpate
{
/// VTK's cropping: two planes across each axis of the image cut it into 27 regions, and bit
/// i + 3 j + 9 k of the flags says whether region (i, j, k) is shown.
class PALPATEVOLUMERENDERING_EXPORT CropRegions
{
public:
  /// Shows everything.
  CropRegions() = default;
  /// `planesIndex`: lower and upper plane along i, j and k, continuous index.
  CropRegions(const std::array<double, 6>& planesIndex, int flags);

  bool ShowsAll() const noexcept { return this->Flags == All; }
  bool Shows(const Vector3& pointIndex) const noexcept;
  /// The six sides of the central region in the world, so that rays skip the outside, if only that
  /// region is shown. Empty otherwise.
  std::vector<HalfSpace> Sides(const FieldGrid& grid) const;

private:
  static constexpr int All = (1 << 27) - 1;
  static constexpr int Middle = 1 << 13;

  std::array<double, 6> Planes{};
  int Flags = All;
};
} // namespace palpate
