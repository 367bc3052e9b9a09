#pragma once

#include "ClosestPoint.h"
#include "ClosestPointDescent.h"
#include "SurfacePatchTree.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// Contact of a spherical tool with a surface.
struct ToolContact
{
  double SignedDistance;   ///< between tool and surface, mm; negative where they overlap
  Vector3 Normal;          ///< outward unit normal at the point closest to the tool's centre
  Vector3 ToolCenterWorld; ///< the proxy: tool centre where the tool just touches, mm
  /// Depth (mm) to which the tool at ToolCenterWorld still penetrates: 0 unless the surface has a
  /// hollow narrower than the tool there.
  double Overlap;
};

/// The point of a surface closest to any query point, over the whole surface or tracked
/// from the last one. Immutable; queries are const, thread-safe and allocation-free. Construction
/// evaluates it some thousand times, so it belongs to the thread that publishes models.
///
/// The global search is branch and bound over the directions (README.md). It ends with a proof (up
/// to rounding), or at the evaluation limit; DistanceError holds the bound in both cases. The
/// surface need not have R > 0, and may cross itself; the sign of the distance then only gives the
/// side of the surface at its closest point.
template <typename Surface>
class ClosestPointSearchOf
{
public:
  using ClosestPoint = ClosestPointOf<Surface>;

  static constexpr int DefaultEvaluationLimit = 1000;
  /// Evaluation limit of one servo tick: more than tracking ever needs on a smooth path.
  static constexpr int TrackingEvaluationLimit = 8;
  static constexpr double TrackingTolerance = SurfaceKind<Surface>::TrackingTolerance;

  explicit ClosestPointSearchOf(std::shared_ptr<const Surface> model);

  const Surface& Model() const noexcept { return *this->Shape; }
  /// For other searches of the same surface.
  const ClosestPointDescentOf<Surface>& Descent() const noexcept { return this->LocalSearch; }
  const SurfacePatchTreeOf<Surface>& Tree() const noexcept { return this->Parts; }

  /// Memory of model and tree.
  std::size_t Bytes() const noexcept;

  /// The closest point of the whole surface; one of them if several are equally close. With a lower
  /// `evaluationLimit` the result is still a point of the surface, and DistanceError holds the
  /// bound that the search reached. Queries up to 1e100 mm; 0.2 MB of stack.
  ClosestPoint Nearest(const Vector3& queryWorld,
                       int evaluationLimit = DefaultEvaluationLimit) const noexcept;
  /// The same with a result for a query nearby, from which the search is shorter.
  ClosestPoint Nearest(const Vector3& queryWorld, int evaluationLimit,
                       const ClosestPoint& near) const noexcept;

  /// The same for the clearance of a tool of this radius (mm): a third of its distance from the
  /// closest point may stay unproven, which saves most of the proof far from the surface.
  ClosestPoint Clearance(const Vector3& queryWorld, double toolRadius,
                         int evaluationLimit = DefaultEvaluationLimit) const noexcept;
  ClosestPoint Clearance(const Vector3& queryWorld, double toolRadius, int evaluationLimit,
                         const ClosestPoint& near) const noexcept;
  static constexpr double ClearanceLeftOpen = 1.0 / 3.0;

  /// The minimum of the distance that continues `previous`, the result of the last tick. One
  /// evaluation if the query moved by up to some hundredths of the radius. Follows its own minimum
  /// even if another one becomes closer, and reports in State if it no longer exists: call Nearest
  /// then. `tolerance` is the allowed error of the angle, rad.
  ClosestPoint Track(const Vector3& queryWorld, const ClosestPoint& previous,
                     double tolerance = TrackingTolerance) const noexcept;

  /// The contact of a spherical tool (radius in mm) with the whole surface. The tool's centre is
  /// placed at the closest point plus radius times normal and pushed out until the tool does not
  /// overlap the surface anywhere; Overlap holds the remaining depth.
  ToolContact TouchAnywhere(const Vector3& toolCenterWorld, double toolRadius) const noexcept;

private:
  ClosestPoint Search(const Vector3& queryWorld, int evaluationLimit, double toolRadius,
                      double part, const ClosestPoint* near = nullptr) const noexcept;

  std::shared_ptr<const Surface> Shape;
  ClosestPointDescentOf<Surface> LocalSearch;
  SurfacePatchTreeOf<Surface> Parts;
};
using ClosestPointSearch = ClosestPointSearchOf<RadialModel>;
} // namespace palpate
