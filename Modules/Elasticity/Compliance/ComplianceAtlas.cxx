#include "ComplianceAtlas.h"

namespace palpate
{
ComplianceAtlas::ComplianceAtlas(const ComplianceMaps& maps)
    : MaximumDegree(maps.Degree), PatchLimit(maps.LargestPatch), Poisson(maps.PoissonRatio)
{
  for (const std::vector<double>& map : maps.Coefficients)
  {
    this->Evaluators.emplace_back(maps.Degree, map);
  }
}

std::size_t ComplianceAtlas::Bytes() const noexcept
{
  std::size_t bytes = sizeof(*this);
  for (const RadialEvaluator& evaluator : this->Evaluators)
  {
    bytes += sizeof(evaluator) + evaluator.TableBytes();
  }
  return bytes;
}

ComplianceAtlas::Place ComplianceAtlas::At(const Vector3& direction) const noexcept
{
  Place place;
  place.Compliance.LargestRadius = this->PatchLimit;
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    const auto sample = this->Evaluators[term].Evaluate(direction);
    place.Compliance.Coefficients[term] = sample.Radius;
    place.Slopes[term] = sample.SurfaceGradient;
  }
  const auto curvature = this->Evaluators[PatchCompliance::Terms].Evaluate(direction);
  place.MeanCurvature = curvature.Radius;
  place.CurvatureSlope = curvature.SurfaceGradient;
  return place;
}
} // namespace palpate
