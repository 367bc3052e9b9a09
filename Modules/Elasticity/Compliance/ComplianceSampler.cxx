#include "ComplianceSampler.h"

#include "SurfaceCurvature.h"

namespace palpate
{
ComplianceSampler::ComplianceSampler(const SphericalHarmonicModel& model, const ElasticSolid& solid,
                                     const ReducedCompliance& reduced)
    : Model(&model), Reduced(&reduced), Local(solid, model.CenterWorld(), reduced.Degree())
{
}

HertzPatch ComplianceSampler::PatchAt(const Vector3& direction, double radius) const noexcept
{
  const auto sample = this->Model->EvaluateSecondOrder(direction);
  const Vector3 normal = (sample.Radius * direction - sample.SurfaceGradient).normalized();
  return {sample.Radius * direction, normal, radius, CurvatureAt(direction, sample).Mean};
}

double ComplianceSampler::Compliance(const HertzPatch& patch) const
{
  return this->Reduced->Compliance(patch) + this->Local.At(patch);
}

PatchCompliance ComplianceSampler::At(const Vector3& direction, double largestRadius) const
{
  std::array<double, PatchCompliance::Terms> values = PatchCompliance::Nodes(largestRadius);
  for (double& value : values)
  {
    value *= this->Compliance(this->PatchAt(direction, value));
  }
  return {PatchCompliance::Interpolate(values), largestRadius};
}
} // namespace palpate
