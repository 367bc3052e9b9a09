#pragma once

#include "GeodesicCurve.h"
#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "ModelFoot.h"
#include "NearestOnMesh.h"
#include "OrganModel.h"
#include "Status.h"
#include "SurfaceModel.h"
#include "SurfacePaths.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Geodesics on a model itself. Immutable; queries are thread-safe and allocate.
class ModelPaths
{
public:
  /// Fails if the model's points are not finite or enclose no volume.
  static Status Make(const OrganModel& model, std::unique_ptr<const ModelPaths>& made);

  /// Between the surface's points that are nearest to these (mm, finite): the shorter of two
  /// curves, straightened from the shortest path on a drawing of triangles, and from the one that
  /// SurfacePaths::Find gives. Another one may be shorter where two routes around an obstacle are
  /// about equally long. Fails only if `progress` cancels.
  Status Find(const Vector3& from, const Vector3& to, const KernelProgress& progress,
              GeodesicCurve& found) const;

  /// 32,000 triangles or more, with points on the model (mm).
  const IndexedMesh& Drawing() const noexcept { return this->Foot.Mesh(); }
  /// Lengths from the surface's point nearest to `from` to the points of Drawing(), exact for its
  /// triangles, which are shorter than the model by (h / R)^2 / 24 (edge h, radius of curvature R).
  /// Fails only if `progress` cancels.
  Status Distances(const Vector3& from, const KernelProgress& progress,
                   std::vector<double>& distances) const;

private:
  explicit ModelPaths(const OrganModel& model);

  // Straightened from a path on the coarse drawing.
  GeodesicCurve CurveFrom(const Vector3& start, const SurfacePaths::Path& path,
                          const Vector3& end) const;

  SurfaceModel Surface;
  ModelFoot Foot;
  NearestOnMesh Nearest;                           // on the drawing
  std::unique_ptr<const SurfacePaths> CoarsePaths; // of a quarter of its triangles
};
} // namespace palpate
