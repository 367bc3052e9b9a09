#include "ComplianceSampler.h"

#include "SurfaceCurvature.h"

namespace palpate
{
ComplianceSampler::ComplianceSampler(const RadialModel& model, const ElasticSolid& solid,
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
  std::vector<HertzPatch> patches;
  for (const double radius : values)
  {
    patches.push_back(this->PatchAt(direction, radius));
  }
  const std::vector<double> longWaves = this->Reduced->Compliances(patches.front().Normal, patches);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] *= longWaves[i] + this->Local.At(patches[i]);
  }
  return {PatchCompliance::Interpolate(values), largestRadius};
}
} // namespace palpate
