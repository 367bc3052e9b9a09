#include "RayOracle.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace palpate::test
{
namespace
{
using Real = RayOracle::Real;

std::string Message(const char* fact, Real t, Real value)
{
  std::ostringstream text;
  text.precision(17);
  text << fact << " at t = " << t << ", relation " << value;
  return text.str();
}

DenseReference::Point PointAt(const FieldRay& ray, Real t)
{
  return {ray.Origin[0] + t * ray.Direction[0], ray.Origin[1] + t * ray.Direction[1],
          ray.Origin[2] + t * ray.Direction[2]};
}

// Bound of the rounding of the ray's coordinates at t, in voxels: when a plane is crossed takes
// three roundings, the coordinates there two, and t between two planes four.
Real RoundingAt(const FieldRay& ray, Real t)
{
  constexpr Real Roundings = 9 * std::numeric_limits<double>::epsilon();
  Real largest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max(largest, std::abs(static_cast<Real>(ray.Origin[axis])) +
                                    std::abs(t * ray.Direction[axis]));
  }
  return Roundings * (1 + largest);
}
} // namespace

Real RayOracle::Relation(const FieldRay& ray, Real t) const
{
  return this->Relation(PointAt(ray, t));
}

bool RayOracle::MayBeZero(const FieldRay& ray, Real t) const
{
  const Real rounding = RoundingAt(ray, t);
  Real least = this->Relation(ray, t);
  Real largest = least;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    DenseReference::Point p = PointAt(ray, t);
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      p[axis] += (corner >> axis & 1u) != 0 ? rounding : -rounding;
    }
    const Real relation = this->Relation(p);
    least = std::min(least, relation);
    largest = std::max(largest, relation);
  }
  return least <= this->Tolerance && largest >= -this->Tolerance;
}

Real RayOracle::Relation(const DenseReference::Point& pointIndex) const
{
  DenseReference::Point p;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    p[axis] = std::clamp<Real>(pointIndex[axis], 0, this->Size[axis] - 1);
  }
  Real relation = std::numeric_limits<Real>::infinity();
  for (const DenseCondition& condition : this->Conditions)
  {
    relation = std::min(relation, condition.Reference->Value(p) - condition.Iso);
  }
  return relation;
}

RayOracle::Interval RayOracle::InGrid(const FieldRay& ray) const
{
  Interval grid{-std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Real o = ray.Origin[static_cast<int>(axis)];
    const Real d = ray.Direction[static_cast<int>(axis)];
    const Real last = this->Size[axis] - 1;
    if (d == 0)
    {
      grid.To = o >= 0 && o <= last ? grid.To : -std::numeric_limits<Real>::infinity();
      continue;
    }
    grid.From = std::max(grid.From, std::min(-o / d, (last - o) / d));
    grid.To = std::min(grid.To, std::max(-o / d, (last - o) / d));
  }
  return grid;
}

std::vector<Real> RayOracle::PlaneCrossings(const FieldRay& ray, const Interval& interval) const
{
  std::vector<Real> crossings{interval.From, interval.To};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Real d = ray.Direction[static_cast<int>(axis)];
    for (int plane = 0; d != 0 && plane < this->Size[axis]; ++plane)
    {
      const Real t = (plane - static_cast<Real>(ray.Origin[static_cast<int>(axis)])) / d;
      if (t > interval.From && t < interval.To)
      {
        crossings.push_back(t);
      }
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

// The roots of the derivative of the cubic through four values.
void RayOracle::AddExtrema(const FieldRay& ray, Real from, Real to, std::vector<Real>& places) const
{
  const Real third = (to - from) / 3;
  const Real f0 = this->Relation(ray, from);
  const Real f1 = this->Relation(ray, from + third);
  const Real f2 = this->Relation(ray, to - third);
  const Real f3 = this->Relation(ray, to);
  // In u = 3 (t - from) / (to - from), from 0 to 3, by divided differences.
  const Real c2 = (f2 - 2 * f1 + f0) / 2;
  const Real c3 = (f3 - 3 * f2 + 3 * f1 - f0) / 6;
  const Real c1 = f1 - f0;
  const Real a = 3 * c3;
  const Real b = 2 * c2 - 6 * c3;
  const Real c = c1 - c2 + 2 * c3;
  const Real root = std::sqrt(std::max<Real>(b * b - 4 * a * c, 0));
  const Real q = -(b + std::copysign(root, b)) / 2;
  for (const Real u : {q / a, c / q})
  {
    if (u > 0 && u < 3)
    {
      places.push_back(from + u * third);
    }
  }
}

bool RayOracle::Contradicts(const FieldRay& ray, const Interval& interval, bool isInside,
                            Real& where) const
{
  constexpr int Between = 16;
  const std::vector<Real> planes = this->PlaneCrossings(ray, interval);
  for (std::size_t n = 0; n + 1 < planes.size(); ++n)
  {
    std::vector<Real> places;
    for (int step = 0; step <= Between; ++step)
    {
      places.push_back(planes[n] + (planes[n + 1] - planes[n]) * step / Between);
    }
    if (this->Conditions.size() == 1 && this->Interpolation == FieldInterpolation::Trilinear)
    {
      this->AddExtrema(ray, planes[n], planes[n + 1], places);
    }
    for (const Real t : places)
    {
      const Real relation = this->Relation(ray, t);
      const bool isOpposite = isInside ? relation < -this->Tolerance : relation > this->Tolerance;
      if (isOpposite && !this->MayBeZero(ray, t))
      {
        where = t;
        return true;
      }
    }
  }
  return false;
}

std::string RayOracle::FaultOfHit(const FieldRay& ray, const FieldHit& hit) const
{
  return this->MayBeZero(ray, hit.T)
             ? std::string()
             : Message("no crossing within rounding", hit.T, this->Relation(ray, hit.T));
}

std::string RayOracle::FaultAtBorder(const FieldRay& ray, const Interval& grid, double tMin,
                                     const FieldHit& hit) const
{
  const Real relation = this->Relation(ray, grid.From);
  const bool isExpected = tMin < grid.From - 1e-9L && relation > this->Tolerance;
  const bool isSaid = hit.Kind == HitKind::Border && hit.IsEntering;
  if (isExpected && !isSaid)
  {
    return Message("no hit where the ray enters the grid inside", grid.From, relation);
  }
  if (hit.Kind == HitKind::Border)
  {
    const Real border = hit.IsEntering ? grid.From : grid.To;
    int axis = 0; // of the face
    hit.Gradient.cwiseAbs().maxCoeff(&axis);
    const Real voxels = std::abs((hit.T - border) * ray.Direction[axis]);
    if (!(voxels <= RoundingAt(ray, hit.T)) || this->Relation(ray, border) < -this->Tolerance)
    {
      return Message("a hit that is not at the border", hit.T, this->Relation(ray, border));
    }
  }
  return {};
}

std::string RayOracle::Fault(const FieldRay& ray, double tMin, double tMax,
                             const FieldHit& hit) const
{
  const Interval grid = this->InGrid(ray);
  const Interval asked{std::max<Real>(grid.From, tMin), std::min<Real>(grid.To, tMax)};
  if (!(asked.To - asked.From > 1e-9L))
  {
    return {}; // grazes, or touches only a corner: rounding decides
  }
  if (hit.Kind != HitKind::Missed && !(hit.T >= tMin && hit.T <= tMax))
  {
    return Message("a hit outside the interval", hit.T, 0);
  }
  std::string fault = this->FaultAtBorder(ray, grid, tMin, hit);
  if (!fault.empty() || (hit.Kind == HitKind::Border && hit.IsEntering))
  {
    return fault;
  }
  const Real start = this->Relation(ray, asked.From);
  const bool isInside = hit.StartsInside != 0;
  if (std::abs(start) > this->Tolerance && isInside != (start > 0))
  {
    return Message("starts on the wrong side", asked.From, start);
  }
  if (hit.Kind == HitKind::Surface)
  {
    fault = hit.IsEntering == isInside ? Message("crosses to its own side", hit.T, 0)
                                       : this->FaultOfHit(ray, hit);
  }
  const Real until = hit.Kind == HitKind::Missed ? asked.To : static_cast<Real>(hit.T);
  Real where = 0;
  if (fault.empty() && until > asked.From &&
      this->Contradicts(ray, {asked.From, until}, isInside, where))
  {
    fault = Message("a crossing was lost before", where, this->Relation(ray, where));
  }
  return fault;
}
} // namespace palpate::test
