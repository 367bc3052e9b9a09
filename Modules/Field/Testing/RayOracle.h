#pragma once

#include "DenseReference.h"
#include "FieldHit.h"
#include "RayCaster.h"

#include <string>
#include <vector>

namespace palpate::test
{
/// One condition of a material, over its dense samples.
struct DenseCondition
{
  const DenseReference* Reference;
  double Iso;
};

/// Checks a ray's hit by evaluating the material's field everywhere on the ray, cell by cell, in
/// long double: at the ends of cells, at the extrema between them where these are exact (one
/// condition, trilinear), and at many points in between.
class RayOracle
{
public:
  using Real = DenseReference::Real;

  RayOracle(const std::array<int, 3>& size, std::vector<DenseCondition> conditions,
            FieldInterpolation interpolation, double tolerance)
      : Size(size), Conditions(std::move(conditions)), Interpolation(interpolation),
        Tolerance(tolerance)
  {
  }

  /// Margin of all conditions on the ray; negative where one does not hold.
  Real Relation(const FieldRay& rayIndex, Real t) const;
  /// Describes an error of the hit; empty if it is correct.
  std::string Fault(const FieldRay& rayIndex, double tMin, double tMax, const FieldHit& hit) const;

private:
  struct Interval
  {
    Real From, To;
  };
  /// Whether the margin is zero, up to the tolerance, where the ray is at t up to rounding.
  bool MayBeZero(const FieldRay& ray, Real t) const;
  Real Relation(const DenseReference::Point& pointIndex) const;
  Interval InGrid(const FieldRay& ray) const;
  std::string FaultAtBorder(const FieldRay& ray, const Interval& grid, double tMin,
                            const FieldHit& hit) const;
  std::string FaultOfHit(const FieldRay& ray, const FieldHit& hit) const;
  /// Whether the field is certainly on the other side somewhere in the interval; `where` is its
  /// place.
  bool Contradicts(const FieldRay& ray, const Interval& interval, bool isInside, Real& where) const;
  std::vector<Real> PlaneCrossings(const FieldRay& ray, const Interval& interval) const;
  void AddExtrema(const FieldRay& ray, Real from, Real to, std::vector<Real>& places) const;

  std::array<int, 3> Size;
  std::vector<DenseCondition> Conditions;
  FieldInterpolation Interpolation;
  double Tolerance; ///< of comparisons with the iso-value
};
} // namespace palpate::test
