#pragma once

#include "ClosestPoint.h"
#include "InstructionSet.h"
#include "SurfaceKind.h"

namespace palpate
{
/// Descends from a start direction to the closest point nearby, also on the servo thread: const,
/// allocation-free, with a fixed maximum number of evaluations.
///
/// Newton's method on the unit sphere for |x(u) - q|^2 / 2, safeguarded: an indefinite Hessian is
/// shifted until it is positive definite, steps are limited, and a step is taken only if the
/// distance decreases (Absil, Mahony and Sepulchre, Optimization Algorithms on Matrix Manifolds,
/// 2008, ch. 6). The last step needs no evaluation: once it is short, point and normal at its
/// end follow from their expansion at its start.
///
/// The error bounds follow from the values at the end and from a bound of the third derivative
/// along great circles, |f'''| <= M = 3 |x'| |x''| + |x - q| |x'''|. With lambda the smallest
/// eigenvalue of the Hessian and G a bound of the remaining gradient, f rises along every great
/// circle by at least -G s + lambda s^2 / 4 up to the angle 1.5 lambda / M. So the minimum is
/// within the angle 4 G / lambda, and f is at most G^2 / lambda above it.
template <typename Surface>
class ClosestPointDescentOf
{
public:
  using ClosestPoint = ClosestPointOf<Surface>;
  using Sample = SampleOf<Surface>;
  using DerivativeBounds = typename SurfaceKind<Surface>::Bounds;

  /// Around a closest point's SampleDirection.
  using Basin = typename SurfaceKind<Surface>::Basin;

  /// Keeps the address of the surface, which must outlive it. The processor must support `set`,
  /// with which results of Continue differ by rounding.
  explicit ClosestPointDescentOf(const Surface& model,
                                 InstructionSet set = FastestInstructionSet());

  /// Descends from the sample at `direction` to the minimum. `query` is relative to the surface's
  /// centre (mm), `tolerance` the allowed error of the angle (rad), `evaluationLimit` >= 0.
  ClosestPoint Run(const Vector3& query, const Vector3& direction, const Sample& sample,
                   double tolerance, int evaluationLimit) const noexcept;

  /// The same from the result of the last tick, for a nearby query; `evaluationLimit` >= 1. On a
  /// surface model the normal stays on the side of the previous one, also where that was
  /// turned round.
  ClosestPoint Continue(const Vector3& query, const ClosestPoint& previous, double tolerance,
                        int evaluationLimit) const noexcept;

  /// Basin of a point that Run found for the same query.
  Basin BasinAround(const Vector3& query, const ClosestPoint& point) const noexcept;

  /// Bounds of the surface over a cap around a sample.
  struct CapBounds
  {
    double First;   ///< |x'| at the sample, mm/rad
    double Second;  ///< |x''| at the sample, mm/rad^2
    double Product; ///< 3 |x'.x''| at the sample, mm^2/rad^3
    double Third;   ///< |x'''| in the cap, mm/rad^3

    /// How far (mm) the surface over a cap of the angle `reach` (rad) extends from the sample.
    double Extent(double reach) const noexcept
    {
      return reach *
             (this->First + reach * (0.5 * this->Second + reach * (1.0 / 6.0) * this->Third));
    }
  };
  static CapBounds BoundsWithin(const DerivativeBounds& bounds, const Vector3& direction,
                                const Sample& sample, double reach) noexcept;
  CapBounds BoundsWithin(const Vector3& direction, const Sample& sample,
                         double reach) const noexcept
  {
    return BoundsWithin(this->Derivatives, direction, sample, reach);
  }
  /// Lower bound of the distance (mm) from the query to the surface over the cap of the angle
  /// `reach` (rad) around `direction`, by the expansion at its centre.
  double LowerDistance(const Vector3& query, const Vector3& direction, const Sample& sample,
                       double reach, const CapBounds& bounds) const noexcept;
  double LowerDistance(const Vector3& query, const Vector3& direction, const Sample& sample,
                       double reach) const noexcept
  {
    return this->LowerDistance(query, direction, sample, reach,
                               this->BoundsWithin(direction, sample, reach));
  }

  const DerivativeBounds& Bounds() const noexcept { return this->Derivatives; }
  /// Bound of the rounding error of a distance (mm): some units in the last place of the numbers
  /// involved.
  double Rounding(const Vector3& query) const noexcept
  {
    return this->UnitRounding * (query.norm() + this->Size);
  }

private:
  ClosestPoint ContinuePortably(const Vector3& query, const ClosestPoint& previous,
                                double tolerance, int evaluationLimit) const noexcept;
  ClosestPoint ContinueByAvx2(const Vector3& query, const ClosestPoint& previous, double tolerance,
                              int evaluationLimit) const noexcept;
  ClosestPoint Follow(const Vector3& query, const ClosestPoint& previous, double tolerance,
                      int evaluationLimit) const noexcept;
  bool Foresee(const Vector3& query, const ClosestPoint& previous, double tolerance,
               double rounding, ClosestPoint& point) const noexcept;
  void Descend(const Vector3& query, double tolerance, int evaluationLimit, double rounding,
               ClosestPoint& point) const noexcept;

  const Surface* Model;
  DerivativeBounds Derivatives;
  double Size;         // of the coordinates of surface points, mm
  double UnitRounding; // relative
  double LongestStep;  // rad
  InstructionSet Set;
};
using ClosestPointDescent = ClosestPointDescentOf<RadialModel>;
} // namespace palpate
