#pragma once

#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// The largest of some values at scattered directions over caps, in constant time: a cube map whose
/// cells hold the largest value within a few angles. Immutable; queries are noexcept and do not
/// allocate.
class CapMaxima
{
public:
  static constexpr std::size_t AngleCount = 3;
  using Angles = std::array<double, AngleCount>;

  CapMaxima() = default;
  /// `values` >= 0 belong to the unit vectors `directions`; `angles` (rad) increase. Directions up
  /// to `margin` (rad) outside of a cap count too. `cells` >= 1 is the number of cells along an
  /// edge of the cube.
  CapMaxima(const std::vector<Vector3>& directions, const std::vector<double>& values,
            const Angles& angles, double margin, int cells);

  /// At least the largest value in the cap around a unit vector; infinite for angles (rad) above
  /// the last one. The answer is the same for all angles between two of the list.
  double Within(const Vector3& center, double angle) const noexcept;
  const Angles& AngleList() const noexcept { return this->Reaches; }

  std::size_t Bytes() const noexcept { return this->Largest.size() * sizeof(Maxima); }

private:
  using Maxima = std::array<float, AngleCount>; // rounded up

  Angles Reaches{};
  int Cells = 0;
  std::vector<Maxima> Largest;
};
} // namespace palpate
