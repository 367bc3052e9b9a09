#pragma once

#include "BodyOverlap.h"
#include "ComparedBody.h"
#include "KernelProgress.h"
#include "MeshDistances.h"
#include "SideBias.h"
#include "Status.h"

#include <optional>
#include <vector>

namespace palpate
{
/// Distances (mm) of the points of one body's surface from the other's.
struct DistanceMap
{
  std::vector<double> Values; ///< negative inside the other body, if that is closed
  DistanceSummary Unsigned;
  double SignedMean = 0.0; ///< NaN if the other surface is open
};

/// Two bodies compared; the second is the reference. Means over a surface are weighted by area.
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

/// `tolerances` (mm) are those of the surface Dice. The distances of a surface are taken at its
/// points and linear in its triangles. Fails only if `progress` cancels.
Status CompareBodies(const ComparedBody& one, const ComparedBody& other,
                     const std::vector<double>& tolerances, const KernelProgress& progress,
                     BodyComparison& comparison);
} // namespace palpate
