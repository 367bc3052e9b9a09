#include "ElasticHold.h"

#include "ClearanceProof.h"
#include "SurfaceCurvature.h"

#include <algorithm>

namespace palpate
{
ElasticHold::ElasticHold(const TouchableRadialModel& surface, double ballRadius,
                         const ClosestPoint* walls, std::size_t count, const Vector3& probeWorld,
                         const Vector3& guessWorld) noexcept
    : Ball(ballRadius), Reach(0.05 * ballRadius), Probe(probeWorld), Center(guessWorld),
      Count(std::min(count, MostWalls))
{
  constexpr int MostSteps = 8;
  constexpr double Tolerance = 1e-7; // of the radius
  std::copy_n(walls, this->Count, this->Known.begin());
  this->GoTo(surface, guessWorld);
  Eigen::Matrix3d slope;
  Vector3 rest = this->Rest(slope);
  for (int step = 0; step < MostSteps && rest.norm() > Tolerance * ballRadius; ++step)
  {
    // Longer steps leave the walls' basins.
    const Vector3 path = -slope.inverse() * rest;
    this->GoTo(surface, this->Center + std::min(1.0, 0.25 * ballRadius / path.norm()) * path);
    rest = this->Rest(slope);
  }
  this->Moved = slope.inverse();
}

// A parabola that ends in a straight line.
ElasticHold::Push ElasticHold::PushAt(double gap) const noexcept
{
  constexpr double Stiffness = 4.0;
  const double in = this->Reach - gap;
  if (!(in > 0.0))
  {
    return {0.0, 0.0};
  }
  return in < 2.0 * this->Reach ? Push{Stiffness * in * in / (4.0 * this->Reach),
                                       -Stiffness * in / (2.0 * this->Reach)}
                                : Push{-Stiffness * gap, -Stiffness};
}

void ElasticHold::GoTo(const TouchableRadialModel& surface, const Vector3& place) noexcept
{
  this->Center = place;
  const std::size_t before = this->Count;
  this->Count = 0;
  for (std::size_t i = 0; i < before; ++i)
  {
    constexpr double Apart = ClearanceProof::Apart;
    const ClosestPoint wall = surface.Search().Track(place, this->Known[i]);
    const auto end = this->Known.begin() + static_cast<std::ptrdiff_t>(this->Count);
    const bool isKnown =
        std::any_of(this->Known.begin(), end,
                    [&](const ClosestPoint& known)
                    { return (known.Direction - wall.Direction).squaredNorm() < Apart * Apart; });
    if (!isKnown)
    {
      this->Known[this->Count++] = wall;
    }
  }
}

// What is left of the equation for the place, and its slope by the place.
Vector3 ElasticHold::Rest(Eigen::Matrix3d& slope) const noexcept
{
  constexpr double LeastStretch = 0.05;
  Vector3 rest = this->Center - this->Probe;
  slope.setIdentity();
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const ClosestPoint& wall = this->Known[i];
    const Push push = this->PushAt(this->GapTo(wall));
    if (!(push.Value > 0.0))
    {
      continue;
    }
    rest -= push.Value * wall.Normal;
    slope -= push.Slope * wall.Normal * wall.Normal.transpose();
    const SurfaceCurvature shape = CurvatureAt(wall.SampleDirection, wall.Sample);
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double bend = shape.Principal[k];
      const Vector3& along = shape.Directions[k];
      slope -= push.Value * bend / std::max(1.0 + wall.SignedDistance * bend, LeastStretch) *
               along * along.transpose();
    }
  }
  return rest;
}
} // namespace palpate
