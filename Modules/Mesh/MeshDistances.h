#pragma once

#include "DistanceSampler.h"
#include "IndexedMesh.h"
#include "NearestOnMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
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

  /// Unsigned distances over this surface from the nearest points of another one (SampleDistances).
  DistanceSamples SamplesFrom(const ComparedSurface& other) const;

private:
  SampledSurface Surface;
  NearestOnMesh Nearest;
};

/// The area (mm^2) of the part of a surface at which `distances` (at its points, finite, linear in
/// the triangles) are at most `limit`. The indices must be valid.
double AreaWithin(const IndexedMesh& mesh, const std::vector<double>& distances, double limit);

/// The signed volume (mm^3) between a point and the part of a surface at which `distances` (at its
/// points, linear in the triangles) are at most `limit`; of a closed surface and the whole of it,
/// the volume that it encloses. The indices must be valid.
double VolumeWithin(const IndexedMesh& mesh, const Vector3& from,
                    const std::vector<double>& distances, double limit);

/// All summaries of two surfaces, over their areas. Fails as TriangleTree::Make does.
Status MeasureMeshDistances(const IndexedMesh& one, const IndexedMesh& other,
                            MeshDistances& distances);
} // namespace palpate
