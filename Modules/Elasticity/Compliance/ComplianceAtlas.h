#pragma once

#include "ComplianceMaps.h"
#include "PatchCompliance.h"
#include "RadialEvaluator.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Evaluates ComplianceMaps: what a servo asks of an elastic organ. Immutable; queries are const,
/// thread-safe and do not allocate.
class ComplianceAtlas
{
public:
  /// At one place.
  struct Place
  {
    PatchCompliance Compliance;
    double MeanCurvature; ///< 1/mm
    /// Of the coefficients of Compliance and of the curvature, tangent to the unit sphere, per rad.
    std::array<Vector3, PatchCompliance::Terms> Slopes;
    Vector3 CurvatureSlope;
  };

  /// The maps have to be complete (ComplianceMaps::Check). Allocates.
  explicit ComplianceAtlas(const ComplianceMaps& maps);

  int Degree() const noexcept { return this->MaximumDegree; }
  double LargestPatch() const noexcept { return this->PatchLimit; }
  double PoissonRatio() const noexcept { return this->Poisson; }
  std::size_t Bytes() const noexcept;

  /// `direction` is a unit vector.
  Place At(const Vector3& direction) const noexcept;

private:
  int MaximumDegree;
  double PatchLimit; // mm
  double Poisson;
  std::vector<RadialEvaluator> Evaluators; // of each map
};
} // namespace palpate
