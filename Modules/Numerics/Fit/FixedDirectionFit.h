#pragma once

#include "MomentTables.h"
#include "PackedTriangle.h"
#include "ResidualMoments.h"
#include "Status.h"
#include "Vector3.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Fits many sets of radii along the same directions: everything that depends on directions,
/// weights and penalty is worked out once. A refit is one pass over the samples and two triangular
/// solves: some 330 products a sample at degree 12, where the matrix that takes radii to
/// coefficients costs 169 but is 5.4 MB of memory to read for 4,002 directions (0.1 MB here).
/// Results equal those of FitSphericalHarmonics to the rounding of the radii times the square of
/// the condition number.
class FixedDirectionFit
{
public:
  /// Largest condition number that Prepare accepts without a penalty.
  static constexpr double HighestCondition = 1e4;

  /// Memory that a refit works in; one for each thread.
  struct Scratch
  {
    ResidualMoments Sums;
    CacheLineVector<double> Coefficients;
  };

  /// Unit directions, weights (only their ratios matter), degree and the strength of the roughness
  /// penalty of FitSphericalHarmonics (0 for none). Refuses what CheckSamples refuses, a strength
  /// that is negative or not finite, and directions that leave the degree undetermined.
  Status Prepare(std::vector<Vector3> directions, const std::vector<double>& weights, int degree,
                 double strength);

  /// How many radii a refit takes, and coefficients it gives; 0 before Prepare.
  std::size_t SampleCount() const noexcept { return this->Directions.size(); }
  std::size_t CoefficientCount() const noexcept
  {
    return static_cast<std::size_t>(this->System.Size());
  }
  /// After Prepare only. Allocates.
  Scratch MakeScratch() const;

  /// From radii (mm) to coefficients (mm). Allocates nothing, takes no lock. False, with the
  /// coefficients as they were, where a radius with a weight is not finite.
  [[nodiscard]] bool Refit(const double* radii, Scratch& scratch,
                           double* coefficients) const noexcept;

private:
  std::shared_ptr<const MomentTables> Tables;
  std::vector<Vector3> Directions;
  std::vector<double> Weights;
  PackedTriangle System;
};
} // namespace palpate
