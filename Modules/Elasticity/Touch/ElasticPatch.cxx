#include "ElasticPatch.h"

#include "RadialModel.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
// Of a c(a) by the direction, tangent to the unit sphere, mm^2/N per rad.
Vector3 SoftnessSlopeOf(const ComplianceAtlas::Place& place, double radius) noexcept
{
  const auto polynomials = PatchCompliance::PolynomialsAt(radius, place.Compliance.LargestRadius);
  Vector3 slope = Vector3::Zero();
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    slope += polynomials.Value[term] * place.Slopes[term];
  }
  return slope;
}
} // namespace

ElasticPatch::ElasticPatch(const ComplianceAtlas& atlas, const RadialModel& model,
                           const Vector3& direction, double depth, double ballRadius) noexcept
    : Place(atlas.At(direction)), Direction(direction), Deep(depth), Ball(ballRadius)
{
  const RadialModel::SecondOrderSample sample = model.EvaluateSecondOrder(direction);
  this->Curvature = CurvatureAt(direction, sample);
  this->SurfaceRadius = sample.Radius;
  this->Foot = sample.Radius * direction;
  this->Outward = (this->Foot - sample.SurfaceGradient).normalized();
  // Where the ball does not fit, the surface is taken as flat as it has to be.
  this->Bend = std::max(this->Place.MeanCurvature, -0.9 / ballRadius);
}

void ElasticPatch::Press(double depth, double start) noexcept
{
  this->Pressed = BallContact::Of(depth, this->Ball, this->Bend, this->Place.Compliance, start);
}

double ElasticPatch::Softness(double radius) const noexcept
{
  const double patch = std::min(radius, this->Place.Compliance.LargestRadius);
  return patch * this->Place.Compliance.At(patch).Compliance;
}

// From a slope by the direction, per rad, which is tangent to the unit sphere.
Vector3 ElasticPatch::OnSurface(const Vector3& slope) const noexcept
{
  const Vector3 onSphere =
      (slope - this->Direction.dot(slope) * this->Direction) / this->SurfaceRadius;
  return onSphere - this->Outward.dot(onSphere) * this->Outward;
}

// 0 in a hollow as round as the ball, which is touched all round: there the nearest point moves
// without bounds, and the ball is not pushed along the surface.
double ElasticPatch::Openness() const noexcept
{
  constexpr double Round = 0.02;
  constexpr double Open = 0.15;
  const double room = 1.0 + this->Ball * this->Curvature.Principal[1];
  return std::clamp((room - Round) / (Open - Round), 0.0, 1.0);
}

Vector3 ElasticPatch::EnergySlope() const noexcept
{
  if (!(this->Pressed.PatchRadius > 0.0))
  {
    return Vector3::Zero();
  }
  const Vector3 compliance =
      SoftnessSlopeOf(this->Place, this->Pressed.PatchRadius) / this->Pressed.PatchRadius;
  return this->Openness() *
         this->OnSurface(-0.5 * this->Pressed.Force * this->Pressed.Force * compliance +
                         this->Pressed.EnergyByCurvature(this->Place.MeanCurvature) *
                             this->Place.CurvatureSlope);
}

Vector3 ElasticPatch::SoftnessSlope(double radius) const noexcept
{
  const double largest = this->Place.Compliance.LargestRadius;
  return this->OnSurface(SoftnessSlopeOf(this->Place, std::min(radius, largest)));
}

Vector3 ElasticPatch::Bent(const Vector3& tangent) const noexcept
{
  Vector3 bent = Vector3::Zero();
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Vector3& along = this->Curvature.Directions[i];
    bent += this->Curvature.Principal[i] * along.dot(tangent) * along;
  }
  return bent;
}

// By (1 + s k)^-1 along each principal direction.
Vector3 ElasticPatch::Followed(const Vector3& motion, double distance) const noexcept
{
  constexpr double LeastStretch = 0.05;
  Vector3 moved = Vector3::Zero();
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Vector3& along = this->Curvature.Directions[i];
    moved += along.dot(motion) /
             std::max(1.0 + distance * this->Curvature.Principal[i], LeastStretch) * along;
  }
  return moved;
}

ElasticForce ElasticPatch::ForceOfHeldBall() const noexcept
{
  constexpr double MostOfBall = 0.5;
  constexpr double MostOfOrgan = 0.2;
  ElasticForce force;
  force.PatchRadius = this->Pressed.PatchRadius;
  force.Energy = this->Pressed.Energy;
  force.Slope = this->Pressed.Slope;
  force.ForceWorld = this->Pressed.Force * this->Outward;
  force.IsValid =
      this->Deep <= std::min(MostOfBall * this->Ball, MostOfOrgan * this->SurfaceRadius) &&
      !this->Pressed.IsPatchFull && this->Bend == this->Place.MeanCurvature;
  return force;
}

ElasticForce ElasticPatch::Force() const noexcept
{
  ElasticForce force = this->ForceOfHeldBall();
  if (!(this->Pressed.PatchRadius > 0.0))
  {
    return force;
  }
  constexpr double MostLateral = 0.5; // of the push; some tenths are met beside lesions
  const Vector3 lateral = -this->Followed(this->EnergySlope(), this->Ball - this->Deep);
  const double size = lateral.norm();
  const double most = MostLateral * this->Pressed.Force;
  force.IsValid = force.IsValid && this->Openness() == 1.0 && size <= most;
  force.ForceWorld += size > most ? Vector3(most / size * lateral) : lateral;
  return force;
}
} // namespace palpate
