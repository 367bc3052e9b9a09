#pragma once

#include "ClearanceProof.h"
#include "ProofBasin.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate
{
// One query.
template <typename Surface>
struct ClearanceProofOf<Surface>::Task
{
  struct Basin
  {
    Vector3 Direction;
    typename ClosestPointDescentOf<Surface>::Basin Around;
    double LowerDistance; // infinite around known minima
    double SquaredChord;  // beyond which no direction is in it
  };

  void Add(const typename ClosestPointDescentOf<Surface>::Basin& around, const Vector3& direction,
           double lowerDistance) noexcept
  {
    if (this->BasinCount < this->Basins.size())
    {
      const auto& limited = Limited(around);
      const double chord = WidestChord(limited);
      this->Basins[this->BasinCount++] = {direction, limited, lowerDistance, chord * chord};
    }
  }
  // Lower bound of the cap's distance by the basins that cover it, mm.
  double LowerDistance(const SphericalCap& cap) const noexcept
  {
    double lower = 0.0;
    for (std::size_t i = 0; i < this->BasinCount; ++i)
    {
      const Basin& basin = this->Basins[i];
      if ((cap.Center - basin.Direction).squaredNorm() < basin.SquaredChord &&
          Contains(basin.Around, basin.Direction, cap))
      {
        lower = std::max(lower, basin.LowerDistance);
      }
    }
    return lower;
  }
  // Whether a descent from here probably ends in a known minimum.
  bool IsNearBasin(const Vector3& direction, double reach) const noexcept
  {
    return std::any_of(this->Basins.begin(),
                       this->Basins.begin() + static_cast<std::ptrdiff_t>(this->BasinCount),
                       [&](const Basin& basin)
                       { return IsNear(basin.Around, basin.Direction, direction, reach); });
  }
  bool IsKnown(const ClosestPoint& minimum) const noexcept
  {
    return std::any_of(this->Known, this->Known + this->KnownCount,
                       [&](const ClosestPoint& known) {
                         return (known.Direction - minimum.Direction).squaredNorm() < Apart * Apart;
                       });
  }

  Vector3 Query;
  const ClosestPoint* Known;
  std::size_t KnownCount;
  int WorkLeft;    // in bounds of nodes
  double Rounding; // of distances, mm
  Answer Result;
  std::array<Basin, 2 * MostKnown> Basins;
  std::size_t BasinCount = 0;
};
} // namespace palpate
