#include "WedgeGroove.h"

#include <cmath>

namespace palpate
{
namespace
{
using Wall = TouchableSurfaceModel::ClosestPoint;

// How fast (1/mm) a wall's normal turns where the sphere moves along a unit vector across it: the
// second derivative of the distance. 0 if unknown.
double TurnAlong(const Wall& wall, const Vector3& along) noexcept
{
  const auto& [first, second] = wall.Sample.First;
  const Vector3 offset = wall.SignedDistance * wall.Normal;
  const double aa = first.squaredNorm() - offset.dot(wall.Sample.Second[0]);
  const double ab = first.dot(second) - offset.dot(wall.Sample.Second[1]);
  const double bb = second.squaredNorm() - offset.dot(wall.Sample.Second[2]);
  const double determinant = aa * bb - ab * ab;
  const double a = first.dot(along);
  const double b = second.dot(along);
  // How far the nearest point moves along with the sphere.
  const double followed = (bb * a * a - 2.0 * ab * a * b + aa * b * b) / determinant;
  const double turn = (1.0 - followed) / wall.SignedDistance;
  return determinant > 0.0 && std::isfinite(turn) ? turn : 0.0;
}
} // namespace

WedgeGroove::WedgeGroove(const Wall& one, const Wall& other, const Vector3& push) noexcept
{
  constexpr double LeastSine = 1e-3;
  constexpr double Longest = 16.0;
  const Vector3 across = one.Normal.cross(other.Normal);
  const double sine = across.norm();
  if (!(sine > LeastSine))
  {
    return;
  }
  this->Along = across / sine;
  const double byOne = push.cross(other.Normal).dot(this->Along) / sine;
  const double byOther = one.Normal.cross(push).dot(this->Along) / sine;
  const double curvature =
      1.0 - byOne * TurnAlong(one, this->Along) - byOther * TurnAlong(other, this->Along);
  // Where it is negative, the place is the farthest from the goal.
  this->Part = curvature > 1.0 / Longest ? 1.0 / curvature : 1.0;
}
} // namespace palpate
