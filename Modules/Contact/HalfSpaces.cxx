#include "HalfSpaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Threshold for unit vectors that count as parallel.
constexpr double Parallel = 1e-7;

// Everything here is relative to the goal, so the goal is the origin and nearest means shortest.
class Problem
{
public:
  Problem(const Vector3& goal, const HalfSpace* spaces, std::size_t count) noexcept
      : Goal(goal), Spaces(spaces)
  {
    constexpr double Roundings = 64.0 * std::numeric_limits<double>::epsilon();
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      largest = std::max(largest, std::abs(this->OffsetOf(i)));
    }
    this->Slack = Roundings * (largest + goal.lpNorm<Eigen::Infinity>());
  }

  // The shortest point within the first `count` half-spaces.
  bool InSpace(std::size_t count, Vector3& point) const noexcept
  {
    point.setZero();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->CutsOff(i, point) && !this->OnPlane(i, point))
      {
        return false;
      }
    }
    return true;
  }

private:
  double OffsetOf(std::size_t i) const noexcept
  {
    return this->Spaces[i].Offset - this->Spaces[i].Normal.dot(this->Goal);
  }
  bool CutsOff(std::size_t i, const Vector3& point) const noexcept
  {
    return this->Spaces[i].Normal.dot(point) < this->OffsetOf(i) - this->Slack;
  }

  // The same on plane `i` within those before it; the point is unchanged if there is none.
  bool OnPlane(std::size_t i, Vector3& point) const noexcept
  {
    const Vector3 normal = this->Spaces[i].Normal;
    Vector3 best = this->OffsetOf(i) * normal;
    for (std::size_t j = 0; j < i; ++j)
    {
      if (this->CutsOff(j, best) && !this->OnLine(i, j, best))
      {
        return false;
      }
    }
    point = best;
    return true;
  }

  // The same on the line where planes `i` and `j` meet, within those before `j`.
  bool OnLine(std::size_t i, std::size_t j, Vector3& point) const noexcept
  {
    const Vector3& a = this->Spaces[i].Normal;
    const Vector3& b = this->Spaces[j].Normal;
    const Vector3 along = a.cross(b);
    const double sine = along.norm();
    const double cosine = a.dot(b);
    if (sine < Parallel)
    {
      return cosine > 0.0; // the same plane twice, or opposite ones
    }
    const Vector3 direction = along / sine;
    // The line's point nearest to the origin, from both planes' equations.
    const double ofA = this->OffsetOf(i);
    const double ofB = this->OffsetOf(j);
    const Vector3 foot = ((ofA - cosine * ofB) * a + (ofB - cosine * ofA) * b) / (sine * sine);
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < j; ++k)
    {
      const double slope = this->Spaces[k].Normal.dot(direction);
      const double missing = this->OffsetOf(k) - this->Spaces[k].Normal.dot(foot);
      if (slope > Parallel)
      {
        least = std::max(least, missing / slope);
      }
      else if (slope < -Parallel)
      {
        most = std::min(most, missing / slope);
      }
      else if (missing > this->Slack)
      {
        return false;
      }
    }
    if (least > most + this->Slack)
    {
      return false;
    }
    point = foot + std::min(std::max(least, 0.0), most) * direction;
    return true;
  }

  Vector3 Goal;
  const HalfSpace* Spaces;
  double Slack; // rounding error of a distance
};
} // namespace

NearestHeld NearestInHalfSpaces(const Vector3& goal, const HalfSpace* spaces,
                                std::size_t count) noexcept
{
  const Problem problem(goal, spaces, count);
  NearestHeld held{goal, false};
  Vector3 point;
  held.IsHeld = problem.InSpace(count, point);
  held.Point = goal + point;
  return held;
}
} // namespace palpate
