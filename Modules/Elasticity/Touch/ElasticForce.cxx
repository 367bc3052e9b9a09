#include "ElasticForce.h"

#include "BallContact.h"
#include "ComplianceAtlas.h"
#include "SphericalHarmonicModel.h"
#include "SurfaceCurvature.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
// Derivative of the energy by the direction of the patch, at the same depth: tangent, N mm/rad.
Vector3 EnergySlope(const ComplianceAtlas::Place& place, const BallContact& contact) noexcept
{
  const auto polynomials =
      PatchCompliance::PolynomialsAt(contact.PatchRadius, place.Compliance.LargestRadius);
  Vector3 compliance = Vector3::Zero();
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    compliance += polynomials.Value[term] * place.Slopes[term];
  }
  compliance /= contact.PatchRadius;
  return -0.5 * contact.Force * contact.Force * compliance +
         contact.EnergyByCurvature(place.MeanCurvature) * place.CurvatureSlope;
}
} // namespace

ElasticForce ElasticForce::Of(const ComplianceAtlas& atlas, const SphericalHarmonicModel& model,
                              const Vector3& direction, double depth, double ballRadius,
                              double start) noexcept
{
  constexpr double MostOfBall = 0.5;
  constexpr double MostOfOrgan = 0.2;
  ElasticForce force;
  if (!(depth > 0.0))
  {
    return force;
  }
  const SphericalHarmonicModel::SecondOrderSample sample = model.EvaluateSecondOrder(direction);
  const ComplianceAtlas::Place place = atlas.At(direction);
  // Where the ball does not fit, the surface is taken as flat as it has to be.
  const double curvature = std::max(place.MeanCurvature, -0.9 / ballRadius);
  const BallContact contact =
      BallContact::Of(depth, ballRadius, curvature, place.Compliance, start);
  const Vector3 normal = (sample.Radius * direction - sample.SurfaceGradient).normalized();
  force.PatchRadius = contact.PatchRadius;
  force.Energy = contact.Energy;
  force.Slope = contact.Slope;
  force.ForceWorld = contact.Force * normal;
  force.IsValid = depth <= std::min(MostOfBall * ballRadius, MostOfOrgan * sample.Radius) &&
                  !contact.IsPatchFull && curvature == place.MeanCurvature;

  // The nearest point moves with the ball by (1 + s k)^-1 along each principal direction, for the
  // centre's distance s from the surface. Where it moves without bounds it is not unique.
  constexpr double LeastStretch = 0.05;
  constexpr double MostLateral = 0.5; // of the push; some tenths are met beside lesions
  const SurfaceCurvature shape = CurvatureAt(direction, sample);
  const double distance = ballRadius - depth;
  const Vector3 slope = EnergySlope(place, contact);
  const Vector3 onSphere = (slope - direction.dot(slope) * direction) / sample.Radius;
  Vector3 lateral = Vector3::Zero();
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double stretch = 1.0 + distance * shape.Principal[i];
    force.IsValid = force.IsValid && stretch > LeastStretch;
    lateral -=
        shape.Directions[i].dot(onSphere) / std::max(stretch, LeastStretch) * shape.Directions[i];
  }
  const double size = lateral.norm();
  const double most = MostLateral * contact.Force;
  force.IsValid = force.IsValid && size <= most;
  force.ForceWorld += size > most ? Vector3(most / size * lateral) : lateral;
  return force;
}
} // namespace palpate
