#pragma once

#include "ClosestPoint.h"
#include "ClosestPointDescent.h"
#include "SurfacePatchTree.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// Where a spherical tool touches a surface.
struct ToolContact
{
  double SignedDistance;   ///< between tool and surface, mm; negative where they overlap
  Vector3 ContactWorld;    ///< point of the surface nearest to the tool's centre, mm
  Vector3 Normal;          ///< outward unit normal there
  Vector3 ToolCenterWorld; ///< where the tool only touches, mm: the proxy
  /// How deep (mm) the tool at ToolCenterWorld is still inside: 0 unless the surface has a hollow
  /// too narrow for it there.
  double Overlap;
};

/// The point of a model's surface nearest to any query point, over the whole surface or continued
/// from the last one. Immutable; queries are const, thread-safe and free of allocation. Building
/// one evaluates the model some thousand times; that is for the thread that publishes models.
///
/// The global search is branch and bound over the directions, best first: SurfacePatchTree bounds
/// the distance of whole parts from below, ClosestPointDescent finds a minimum from the most
/// promising one and proves how far around no point is nearer, and what neither excludes is cut
/// finer. It ends with a proof (up to rounding), or when its evaluations are used up; DistanceError
/// says in both cases what is certain. The surface need not have R > 0; the sign of the distance
/// then means only the side of the surface at its nearest point.
class ClosestPointSearch
{
public:
  static constexpr int DefaultEvaluationLimit = 1000;
  /// One servo tick must end: more evaluations than tracking ever needs on a smooth path.
  static constexpr int TrackingEvaluationLimit = 8;
  /// Angle (rad) that a tracked point may be off its minimum; the distance is then off by the
  /// square of it, far below rounding. Of models in float, it is what their rounding leaves.
  static constexpr double TrackingTolerance = 1e-7;

  explicit ClosestPointSearch(std::shared_ptr<const SphericalHarmonicModel> model);

  const SphericalHarmonicModel& Model() const noexcept { return *this->Surface; }
  /// What other searches of the same surface share.
  const ClosestPointDescent& Descent() const noexcept { return this->LocalSearch; }
  const SurfacePatchTree& Tree() const noexcept { return this->Parts; }

  /// What model and tree occupy.
  std::size_t Bytes() const noexcept
  {
    return this->Surface->Coefficients().size() * sizeof(double) + this->Parts.Bytes();
  }

  /// The nearest point of the whole surface. Where several are equally near, one of them. With
  /// `evaluationLimit` fewer evaluations may be allowed; the result is then still a point of the
  /// surface, and DistanceError says what the search could not exclude. Queries up to 1e100 mm; 0.2
  /// MB of stack.
  ClosestPoint Nearest(const Vector3& queryWorld,
                       int evaluationLimit = DefaultEvaluationLimit) const noexcept;

  /// The same where it only matters how far a tool of this radius (mm) may go: a third of its way
  /// to the nearest point may stay open, which spares most of the proof far from the surface.
  ClosestPoint Clearance(const Vector3& queryWorld, double toolRadius,
                         int evaluationLimit = DefaultEvaluationLimit) const noexcept;
  static constexpr double ClearanceLeftOpen = 1.0 / 3.0;

  /// The minimum of the distance that continues `previous`, the result of the last tick. One
  /// evaluation if the query moved by up to some hundredths of the radius. It follows its own
  /// minimum even if another one becomes nearer, and says so if there is none any more (State):
  /// ask Nearest then.
  ClosestPoint Track(const Vector3& queryWorld, const ClosestPoint& previous) const noexcept;
  /// The same from any unit vector; one evaluation more.
  ClosestPoint Track(const Vector3& queryWorld, const Vector3& previousDirection) const noexcept;

  /// The contact of a spherical tool (radius in mm) whose centre has the given closest point. The
  /// tool's centre is put at the point plus radius times normal, which is right unless the surface
  /// has a hollow narrower than the tool there; Overlap is not looked for and 0. For every tick.
  static ToolContact Touch(const ClosestPoint& closest, double toolRadius) noexcept;
  /// The same over the whole surface, with the tool's centre pushed out until the tool is free of
  /// it everywhere, or Overlap says what remains.
  ToolContact TouchAnywhere(const Vector3& toolCenterWorld, double toolRadius) const noexcept;

private:
  ClosestPoint Search(const Vector3& queryWorld, int evaluationLimit, double toolRadius,
                      double part) const noexcept;

  std::shared_ptr<const SphericalHarmonicModel> Surface;
  ClosestPointDescent LocalSearch;
  SurfacePatchTree Parts;
};
} // namespace palpate
