#pragma once

#include "IndexedMesh.h"
#include "NearestOnMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// Distances (mm) of the points of a surface from another one, weighted by the points' areas.
struct DistanceSummary
{
  double Mean = 0.0;
  double Rms = 0.0;
  double Percentile95 = 0.0; ///< least distance not exceeded on 95 % of the area
  double Largest = 0.0;
};

struct MeshDistances
{
  DistanceSummary OneToOther;
  DistanceSummary OtherToOne;
  DistanceSummary Both; ///< of both together, each side with half of the weight
};

/// A third of the area of the triangles around each point, mm^2. The indices must be valid.
std::vector<double> PointAreas(const IndexedMesh& mesh);

/// A surface prepared for comparisons with several others. Immutable.
class ComparedSurface
{
public:
  /// Fails as TriangleTree::Make does.
  static Status Make(const IndexedMesh& mesh, ComparedSurface& made);

  /// Unsigned distances (mm) of its points from the nearest point of another one; finite triangles
  /// matter, so both need points as dense as their shape requires.
  std::vector<double> DistancesFrom(const ComparedSurface& other) const;
  /// The points' parts of the area, which sum to 1; equal for a surface without area.
  const std::vector<double>& Weights() const noexcept { return this->Parts; }

private:
  std::vector<double> Parts;
  NearestOnMesh Nearest;
};

/// `weights` must have a value per distance and sum to 1. Points without area have no weight, but
/// count for the largest distance.
DistanceSummary Summarise(const std::vector<double>& distances, const std::vector<double>& weights);

/// Distances in both directions together, each with half of the weight; symmetric.
DistanceSummary TwoSidedDistances(const std::vector<double>& there,
                                  const std::vector<double>& weightsThere,
                                  const std::vector<double>& back,
                                  const std::vector<double>& weightsBack);

/// The share of a surface's area at which `distances` (at its points, not negative, linear in the
/// triangles) are at most `limit`; 0 for a surface without area. The indices must be valid.
double ShareWithin(const IndexedMesh& mesh, const std::vector<double>& distances, double limit);

/// The signed volume (mm^3) between a point and the part of a surface at which `distances` (at its
/// points, linear in the triangles) are at most `limit`; of a closed surface and the whole of it,
/// the volume that it encloses. The indices must be valid.
double VolumeWithin(const IndexedMesh& mesh, const Vector3& from,
                    const std::vector<double>& distances, double limit);

/// All summaries of two surfaces. Fails as TriangleTree::Make does.
Status MeasureMeshDistances(const IndexedMesh& one, const IndexedMesh& other,
                            MeshDistances& distances);
} // namespace palpate
