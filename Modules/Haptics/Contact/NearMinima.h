#pragma once

#include "ClearanceProof.h"
#include "ParametricTouchSurface.h"

namespace palpate
{
/// Finds the nearest point of a parametric surface for a tool that moves near it without contact:
/// the minimum of the distance that was nearest before is followed, and a ClearanceProof, whose
/// bounds last for many ticks, shows that no other one is nearer. For one thread; does not
/// allocate.
class NearMinima
{
public:
  using ClosestPoint = ParametricTouchSurface::ClosestPoint;

  /// Works up to the distance `reach` (mm). Minima whose distance is not known to `exactness` (mm)
  /// are not used. Keeps the address of the surface, which must outlive it.
  NearMinima(const ParametricTouchSurface& surface, double reach, double exactness) noexcept;

  /// Has to be called before the queries of a tick.
  void BeginTick() noexcept { this->IsUsedUp = false; }
  /// Returns false if another search is needed; else `nearest` is the closest point of the whole
  /// surface. `from` is one nearby. Subtracts its evaluations from `evaluationsLeft`.
  bool Find(const Vector3& queryWorld, const ClosestPoint& from, int& evaluationsLeft,
            ClosestPoint& nearest) noexcept;

private:
  using Proof = ClearanceProofOf<ParametricTouchSurface::Shape>;

  bool IsExact(const ClosestPoint& minimum) const noexcept
  {
    return minimum.Converged() && minimum.DistanceError <= this->Exactness;
  }

  const ClosestPointSearchOf<ParametricTouchSurface::Shape>* Search;
  double Reach;     // mm
  double Exactness; // mm
  Proof Clearance;
  bool IsUsedUp = false; // a proof was too long for this tick
};
} // namespace palpate
