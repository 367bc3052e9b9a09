#include "ElasticPatch.h"

#include "SphericalHarmonicModel.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
ElasticPatch::ElasticPatch(const ComplianceAtlas& atlas, const SphericalHarmonicModel& model,
                           const Vector3& direction, double depth, double ballRadius) noexcept
    : Place(atlas.At(direction)), Direction(direction), Deep(depth), Ball(ballRadius)
{
  const SphericalHarmonicModel::SecondOrderSample sample = model.EvaluateSecondOrder(direction);
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

// Derivative of the energy by the direction of the patch, at the same depth: tangent, N mm/rad.
Vector3 ElasticPatch::EnergySlope() const noexcept
{
  const auto polynomials = PatchCompliance::PolynomialsAt(this->Pressed.PatchRadius,
                                                          this->Place.Compliance.LargestRadius);
  Vector3 compliance = Vector3::Zero();
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    compliance += polynomials.Value[term] * this->Place.Slopes[term];
  }
  compliance /= this->Pressed.PatchRadius;
  return -0.5 * this->Pressed.Force * this->Pressed.Force * compliance +
         this->Pressed.EnergyByCurvature(this->Place.MeanCurvature) * this->Place.CurvatureSlope;
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
  // The nearest point moves with the ball by (1 + s k)^-1 along each principal direction, for the
  // centre's distance s from the surface. In a hollow as round as the ball it moves without bounds:
  // there the ball is touched all round, and not pushed along the surface.
  constexpr double Round = 0.02;
  constexpr double Open = 0.15;
  constexpr double LeastStretch = 0.05;
  constexpr double MostLateral = 0.5; // of the push; some tenths are met beside lesions
  const double distance = this->Ball - this->Deep;
  const Vector3 slope = this->EnergySlope();
  const Vector3 onSphere =
      (slope - this->Direction.dot(slope) * this->Direction) / this->SurfaceRadius;
  const double room = 1.0 + this->Ball * this->Curvature.Principal[1];
  const double share = std::clamp((room - Round) / (Open - Round), 0.0, 1.0);
  force.IsValid = force.IsValid && share == 1.0;
  Vector3 lateral = Vector3::Zero();
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double curvature = this->Curvature.Principal[i];
    lateral -= share * this->Curvature.Directions[i].dot(onSphere) /
               std::max(1.0 + distance * curvature, LeastStretch) * this->Curvature.Directions[i];
  }
  const double size = lateral.norm();
  const double most = MostLateral * this->Pressed.Force;
  force.IsValid = force.IsValid && size <= most;
  force.ForceWorld += size > most ? Vector3(most / size * lateral) : lateral;
  return force;
}
} // namespace palpate
