#pragma once

#include "Vector3.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
/// Four numbers at once, by GCC and Clang's vector extension. Functions take and give them by
/// reference, since their calling convention as values depends on the instruction set.
typedef double FourLanes __attribute__((vector_size(4 * sizeof(double))));

/// Of negative numbers 0.
inline void SquareRoot(const FourLanes& square, FourLanes& root) noexcept
{
  const FourLanes positive = square > 0.0 ? square : FourLanes{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    root[i] = std::sqrt(positive[i]);
  }
}

/// Lower bounds of the distances of four parts of a surface, each known for a place of its own, for
/// other places. For a step d from the place p of a bound b, a part within e of the point x is at
/// least sqrt(b^2 - 2 (d.(x - p) + |d| e) + |d|^2) away: steps along the surface hardly change it.
///
/// All four at once.
struct alignas(sizeof(FourLanes)) MovedBounds
{
  static constexpr std::size_t Count = 4;

  /// Without bounds: all are 0.
  void Forget() noexcept
  {
    *this = {};
    this->Square += std::numeric_limits<double>::lowest();
  }
  /// The part is within `extent` of `point`, and at least `lower` > 0 from `place`, all mm.
  void Set(std::size_t part, const Vector3& place, double lower, const Vector3& point,
           double extent) noexcept
  {
    const Vector3 away = point - place;
    this->PlaceX[part] = place[0];
    this->PlaceY[part] = place[1];
    this->PlaceZ[part] = place[2];
    this->AwayX[part] = away[0];
    this->AwayY[part] = away[1];
    this->AwayZ[part] = away[2];
    this->Extent[part] = extent;
    this->Square[part] = lower * lower;
  }
  /// The bounds (mm) of the distances from `place`, up to rounding, are `lower`.
  void Move(const Vector3& place, FourLanes& lower) const noexcept
  {
    const FourLanes x = place[0] - this->PlaceX;
    const FourLanes y = place[1] - this->PlaceY;
    const FourLanes z = place[2] - this->PlaceZ;
    const FourLanes step = x * x + y * y + z * z;
    const FourLanes along = x * this->AwayX + y * this->AwayY + z * this->AwayZ;
    FourLanes length;
    SquareRoot(step, length);
    SquareRoot(this->Square - 2.0 * (along + length * this->Extent) + step, lower);
  }

private:
  FourLanes PlaceX, PlaceY, PlaceZ; // of the bounds, mm
  FourLanes AwayX, AwayY, AwayZ;    // from there to a point of the part, mm
  FourLanes Square;                 // of the bounds, mm^2
  FourLanes Extent;                 // of the part around that point, mm
};
} // namespace palpate
