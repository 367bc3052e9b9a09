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

ElasticForce ElasticPatch::Force(const Vector3& energySlope) const noexcept
{
  constexpr double MostOfBall = 0.5;
  constexpr double MostOfOrgan = 0.2;
  ElasticForce force;
  if (!(this->Pressed.PatchRadius > 0.0))
  {
    return force;
  }
  force.PatchRadius = this->Pressed.PatchRadius;
  force.Energy = this->Pressed.Energy;
  force.Slope = this->Pressed.Slope;
  force.ForceWorld = this->Pressed.Force * this->Outward;
  force.IsValid =
      this->Deep <= std::min(MostOfBall * this->Ball, MostOfOrgan * this->SurfaceRadius) &&
      !this->Pressed.IsPatchFull && this->Bend == this->Place.MeanCurvature;

  // The nearest point moves with the ball by (1 + s k)^-1 along each principal direction, for the
  // centre's distance s from the surface. Where it moves without bounds it is not unique.
  constexpr double LeastStretch = 0.05;
  constexpr double MostLateral = 0.5; // of the push; some tenths are met beside lesions
  const double distance = this->Ball - this->Deep;
  const Vector3 slope = this->EnergySlope();
  const Vector3 onSurface =
      (slope - this->Direction.dot(slope) * this->Direction) / this->SurfaceRadius + energySlope;
  Vector3 lateral = Vector3::Zero();
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double stretch = 1.0 + distance * this->Curvature.Principal[i];
    force.IsValid = force.IsValid && stretch > LeastStretch;
    lateral -= this->Curvature.Directions[i].dot(onSurface) / std::max(stretch, LeastStretch) *
               this->Curvature.Directions[i];
  }
  const double size = lateral.norm();
  const double most = MostLateral * this->Pressed.Force;
  force.IsValid = force.IsValid && size <= most;
  force.ForceWorld += size > most ? Vector3(most / size * lateral) : lateral;
  return force;
}
} // namespace palpate
