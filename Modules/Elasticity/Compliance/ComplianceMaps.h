#pragma once

#include "HexElasticity.h"
#include "KernelProgress.h"
#include "PackedCompliance.h"
#include "PatchCompliance.h"
#include "RadialModel.h"
#include "ReducedCompliance.h"
#include "Status.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// The compliance of every place of an organ's surface to Hertz bumps, as spherical harmonics: one
/// map for each term of PatchCompliance (mm^2/N), and one of the mean curvature (1/mm). All that a
/// servo needs of an elastic organ, some ten kilobytes; ComplianceAtlas evaluates it. Pictures need
/// besides how the whole organ moves.
struct ComplianceMaps
{
  static constexpr std::size_t Count = PatchCompliance::Terms + 1;
  static constexpr int MostDegree = 40;
  /// Of the harmonics that are kept for pictures; shorter waves are drawn locally.
  static constexpr int DrawnDegree = 10;
  /// Of the mean radius, the default of the largest patch.
  static constexpr double DefaultPatch = 0.36;

  struct Settings
  {
    int Degree = 20;           ///< of the maps, 0 to MostDegree
    double LargestPatch = 0.0; ///< mm; if not positive, DefaultPatch of the mean radius
  };

  /// What the maps leave out, at directions between those that they were fitted to.
  struct Error
  {
    double Rms = 0.0;     ///< of the compliance, relative
    double Largest = 0.0; ///< relative
    Vector3 Worst = Vector3::UnitZ();
    double PatchRadius = 0.0; ///< mm, of the bumps that were compared
  };

  int Degree = 0;
  double LargestPatch = 0.0; ///< mm
  double PoissonRatio = 0.0;
  std::array<std::vector<double>, Count> Coefficients; ///< (Degree + 1)^2 each
  Error FitError;
  PackedCompliance LongWaves; ///< for pictures; may be empty

  /// Of the model, the solid and the compliance that was reduced from them. Maps that would
  /// overshoot to what no body is are smoothed until they pass Check or are too smooth for it;
  /// FitError has what that costs. Fails for settings outside their limits and if `progress`
  /// cancels. Allocates.
  static Status Fit(const RadialModel& model, const ElasticSolid& solid,
                    const ReducedCompliance& reduced, const Settings& settings,
                    const KernelProgress& progress, ComplianceMaps& maps);

  /// Up to a degree, or their own if that is lower: faster to evaluate. What they leave out is not
  /// known then (FitError is empty); pictures keep their long waves. Allocates.
  ComplianceMaps Truncated(int degree) const;

  /// Fails for maps that are incomplete or beyond physical limits; up to half of the largest patch
  /// a larger one has to yield less. For maps from a file. Allocates.
  Status Check() const;
};
} // namespace palpate
