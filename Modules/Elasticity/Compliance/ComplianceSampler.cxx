#include "ComplianceSampler.h"

#include "SurfaceCurvature.h"

namespace palpate
{
ComplianceSampler::ComplianceSampler(const SphericalHarmonicModel& model, const ElasticSolid& solid,
                                     const ReducedCompliance& reduced)
    : Model(&model), Reduced(&reduced), Basis(reduced.Degree()),
      Local(solid, model.CenterWorld(), reduced.Degree())
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
  const auto harmonics = static_cast<Eigen::Index>(this->Basis.Size());
  Eigen::VectorXd bump(harmonics);
  patch.Project(this->Basis, bump.data());
  for (int l = 0; l <= this->Reduced->Degree(); ++l)
  {
    bump.segment(Eigen::Index{l} * l, 2 * Eigen::Index{l} + 1) *=
        ReducedCompliance::Window(l, this->Reduced->Degree());
  }
  Eigen::VectorXd traction(3 * harmonics);
  for (Eigen::Index component = 0; component < 3; ++component)
  {
    traction.segment(component * harmonics, harmonics) = patch.Normal[component] * bump;
  }
  return traction.dot(this->Reduced->Matrix().selfadjointView<Eigen::Lower>() * traction) +
         this->Local.At(patch);
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
