#pragma once

#include "HexElasticity.h"
#include "KernelProgress.h"
#include "PatchCompliance.h"
#include "ReducedCompliance.h"
#include "SphericalHarmonicEvaluator.h"
#include "SphericalHarmonicModel.h"
#include "Status.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// The compliance of every place of an organ's surface to Hertz bumps, as spherical harmonics: one
/// map for each term of PatchCompliance, and one of the mean curvature. What a servo needs of an
/// elastic organ; some ten kilobytes. Immutable once made; queries are const, thread-safe and do
/// not allocate.
class ComplianceAtlas
{
public:
  struct Settings
  {
    int Degree = 20;           ///< of the maps, 0 to MostDegree
    double LargestPatch = 0.0; ///< mm; if not positive, DefaultPatch of the mean radius
  };
  static constexpr int MostDegree = 40;
  static constexpr double DefaultPatch = 0.36;

  /// At one place.
  struct Place
  {
    PatchCompliance Compliance;
    double MeanCurvature; ///< 1/mm
    /// Of the coefficients of Compliance and of the curvature, tangent to the unit sphere, per rad.
    std::array<Vector3, PatchCompliance::Terms> Slopes;
    Vector3 CurvatureSlope;
  };

  /// What the maps leave out, at directions between those that they were fitted to.
  struct Error
  {
    double Rms = 0.0;     ///< of the compliance, relative
    double Largest = 0.0; ///< relative
    Vector3 Worst = Vector3::UnitZ();
    double PatchRadius = 0.0; ///< mm, of the bumps that were compared
  };

  /// Of the model, the solid and the compliance that was reduced from them. Fails for settings
  /// outside their limits and if `progress` cancels. Allocates.
  static Status Make(const SphericalHarmonicModel& model, const ElasticSolid& solid,
                     const ReducedCompliance& reduced, const Settings& settings,
                     const KernelProgress& progress, ComplianceAtlas& atlas);

  int Degree() const noexcept { return this->MaximumDegree; }
  double LargestPatch() const noexcept { return this->PatchLimit; }
  double PoissonRatio() const noexcept { return this->Poisson; }
  const Error& FitError() const noexcept { return this->Left; }
  std::size_t Bytes() const noexcept;

  /// `direction` is a unit vector.
  Place At(const Vector3& direction) const noexcept;

private:
  static constexpr std::size_t Maps = PatchCompliance::Terms + 1;

  int MaximumDegree = 0;
  double PatchLimit = 0.0; // mm
  double Poisson = 0.0;
  std::vector<SphericalHarmonicEvaluator> Evaluators;
  Error Left;
};
} // namespace palpate
