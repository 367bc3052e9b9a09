#pragma once

#include "BodyOverlap.h"
#include "ComparedBody.h"
#include "DistanceSamples.h"
#include "KernelProgress.h"
#include "SideBias.h"
#include "Status.h"

#include <optional>
#include <vector>

namespace palpate
{
/// Distances (mm) of one body's surface from the other's; negative inside the other body, if that
/// is closed.
struct DistanceMap
{
  std::vector<double> Values; ///< at the surface's points
  DistanceSamples Samples;    ///< over its area
  DistanceSummary Unsigned;
  double SignedMean = 0.0; ///< NaN if the other surface is open
};

/// Two bodies compared; the second is the reference. Means over a surface are over its area.
struct BodyComparison
{
  struct Tolerance
  {
    double Millimeters = 0.0;
    double SurfaceDice = 0.0; ///< see the function of this name
  };

  std::optional<BodyOverlap> Overlap; ///< of closed bodies
  DistanceMap OneToOther;
  DistanceMap OtherToOne;
  /// Of both directions together, each with half of the weight; the maximum is the Hausdorff
  /// distance.
  DistanceSummary Both;
  /// Least distance (mm) between closed bodies, 0 if they share volume; of an open one, between the
  /// surfaces. Exact for triangles; a model's are some micrometres inside it.
  double LeastDistance = 0.0;
  std::vector<Tolerance> Tolerances;
  /// Of the first surface around the reference's centroid; if the reference is closed.
  std::optional<SideBias> Bias;

  /// The larger of the two directions' 95th percentiles ("95 % Hausdorff distance").
  double Hausdorff95() const noexcept;
};

/// Normalised surface Dice at each tolerance (mm): the area of both surfaces that is within the
/// tolerance of the other one, divided by the area of both (Nikolov et al., "Clinically applicable
/// segmentation of head and neck anatomy for radiotherapy", J. Med. Internet Res. 23 (2021)
/// e26151).
std::vector<double> SurfaceDice(const ComparedBody& one, const DistanceMap& there,
                                const ComparedBody& other, const DistanceMap& back,
                                const std::vector<double>& tolerances);

/// `tolerances` (mm) are those of the surface Dice. Means and percentiles are within 1 % of those
/// over the area, largest distances as a rule within 0.1 % (SampleDistances). Fails only if
/// `progress` cancels.
Status CompareBodies(const ComparedBody& one, const ComparedBody& other,
                     const std::vector<double>& tolerances, const KernelProgress& progress,
                     BodyComparison& comparison);
} // namespace palpate
