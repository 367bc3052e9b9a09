#pragma once

#include "CenteredSurface.h"
#include "ClosestPointDescent.h"
#include "FourLanes.h"
#include "InstructionSet.h"
#include "Vector3.h"

#include <cstddef>
#include <limits>

namespace palpate
{
/// Lower bounds of the distances of four parts of a surface model from a place, each by the
/// expansion at its middle: ClosestPointDescentOf<CenteredSurface>::LowerDistance, four at once,
/// since the time of one is that of its roots and divisions one after another.
class alignas(sizeof(FourLanes)) ExpandedParts
{
public:
  static constexpr std::size_t Count = 4;

  /// Without parts: the bounds of all are 0.
  void Forget() noexcept
  {
    this->Reach = FourLanes{} + 1.0;
    this->Third = FourLanes{} + Unbounded;
  }
  /// The part over the cap of the angle `reach` (rad) around the sample's parameter.
  void Set(std::size_t part, const CenteredSurface::SecondOrderSample& sample, double reach,
           const ClosestPointDescentOf<CenteredSurface>::CapBounds& bounds) noexcept;
  /// The part is within the extent (mm) of this point, relative to the surface's centre.
  Vector3 PointOf(std::size_t part) const noexcept
  {
    return {this->Point[0][part], this->Point[1][part], this->Point[2][part]};
  }
  double ExtentOf(std::size_t part) const noexcept { return this->Extent[part]; }
  /// mm, up to rounding; the place is relative to the surface's centre. The processor must support
  /// `set`.
  void LowerDistance(const Vector3& place, InstructionSet set, FourLanes& lower) const noexcept;

private:
  static constexpr double Unbounded = std::numeric_limits<double>::infinity();
  typedef FourLanes Coordinates[3];

  static void Put(std::size_t part, const Vector3& vector, Coordinates& lanes) noexcept;
  void Bound(const Vector3& place, FourLanes& lower) const noexcept;
  void BoundPortably(const Vector3& place, FourLanes& lower) const noexcept;
  void BoundByAvx2(const Vector3& place, FourLanes& lower) const noexcept;

  Coordinates Point{}; // at the parts' middles, mm
  Coordinates First[2]{};
  Coordinates Second[3]{};
  FourLanes Metric[3]{};               // products of the first derivatives
  FourLanes Reach = FourLanes{} + 1.0; // rad
  FourLanes Product{};                 // of the bounds
  FourLanes Third = FourLanes{} + Unbounded;
  FourLanes Longer{}; // how far the parts extend, without third derivatives, mm
  FourLanes Extent{}; // and with them
};
} // namespace palpate
