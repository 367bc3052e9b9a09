#pragma once

#include "RayPath.h"

namespace palpate
{
/// The part of a ray in one cell, between the planes that it crosses.
struct CellSegment
{
  double T0, T1;
  /// Ends in the cell along i, j, k, from 0 to 1; exactly 0 or 1 along axes whose planes are
  /// crossed.
  double U0[4], U1[4];

  CellSegment(const RayPath& path, const int* cell, double t0, double t1) noexcept : T0(t0), T1(t1)
  {
    for (int pair = 0; pair < 2; ++pair)
    {
      const int second = pair == 0 ? cell[1] : 0;
      const Pair low{static_cast<double>(cell[2 * pair]), static_cast<double>(second)};
      const Pair ahead = path.AheadOf(pair); // 1 where the ray rises
      const Pair before = 1.0 - ahead;
      const Pair entries = path.Crossings(pair, low + before);
      const Pair exits = path.Crossings(pair, low + ahead);
      const Pair u0 = Within(path.Coordinates(pair, t0) - low);
      const Pair u1 = Within(path.Coordinates(pair, t1) - low);
      Store(entries == t0 ? before : u0, this->U0 + 2 * pair);
      Store(exits == t1 ? ahead : u1, this->U1 + 2 * pair);
    }
  }

  double At(double parameter) const noexcept
  {
    const double t = this->T0 + parameter * (this->T1 - this->T0);
    return t < this->T1 ? t : this->T1;
  }
  static double Within(double u) noexcept { return std::max(0.0, std::min(1.0, u)); }

private:
  using Pair = RayPath::Pair;
  static Pair Within(const Pair& u) noexcept
  {
    const Pair atMost = u < 1.0 ? u : Pair{1.0, 1.0};
    return atMost > 0.0 ? atMost : Pair{};
  }
  static void Store(const Pair& pair, double* two) noexcept
  {
    two[0] = pair[0];
    two[1] = pair[1];
  }
};
} // namespace palpate
