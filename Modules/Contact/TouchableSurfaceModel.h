#pragma once

#include "ClosestPointSearch.h"
#include "Status.h"
#include "WindingMesh.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace palpate
{
class WedgePlaces;

/// A surface model prepared for touch, shared by its trackers: the same as TouchableRadialModel,
/// for surfaces that may wrap round anything and may cross themselves. Inside is where the winding
/// number is not 0. Immutable; queries are noexcept and do not allocate, except PlacesFor.
///
/// The sign of the distance from one sheet of a surface tells inside from outside only near it, and
/// only where no other sheet crosses. So closest points are seen from a side: SignedDistance is
/// positive and Normal points outward on the side that the tool is known to have come from.
class TouchableSurfaceModel
{
public:
  using Shape = CenteredSurface;
  using ClosestPoint = ClosestPointOf<Shape>;
  static constexpr bool MayCrossItself = true;
  static constexpr bool CountsAllWork = true;
  /// Evaluations in a tick, of about 0.6 µs on a core of an AMD EPYC up to degree 16. They are
  /// counted, not timed, so that a recording replays bit for bit.
  int EvaluationsOfTick() const noexcept;

  /// A point of the surface, by its parameter.
  struct Place
  {
    Vector3 Direction;  ///< the parameter, a unit vector
    Vector3 PointWorld; ///< mm
    Vector3 Normal;     ///< unit normal
  };

  /// Fails for a surface with numbers that are not finite or too large to be squared, and for one
  /// without a volume. One that is inside out (negative volume) is turned. Takes some 100
  /// milliseconds, half a second more if it crosses itself; allocates.
  static Status Make(const SurfaceModel& surface,
                     std::shared_ptr<const TouchableSurfaceModel>& touch);

  const ClosestPointSearchOf<Shape>& Search() const noexcept { return this->Closest; }
  const Shape& Model() const noexcept { return this->Closest.Model(); }
  std::size_t Bytes() const noexcept;
  /// Three times the volume by the area, mm: the radius of a sphere, about that of a tube, and half
  /// the thickness of a sheet, up to a factor of 1.5.
  double SmallestRadius() const noexcept { return this->Smallest; }
  /// Bound of the distance from the centre, mm.
  double LargestRadius() const noexcept { return this->Closest.Tree().LargestRadius(); }
  /// Rounding error of a distance near the surface, mm.
  double Rounding() const noexcept
  {
    return this->Closest.Descent().Rounding(Vector3::Constant(this->LargestRadius()));
  }

  /// Whether a tessellation of twice the degree crosses itself, and places where it does: all, if
  /// there are fewer than MostCrossings.
  static constexpr std::size_t MostCrossings = 20000;
  bool CrossesItself() const noexcept { return !this->Crossings.empty(); }
  const std::vector<Vector3>& CrossingsWorld() const noexcept { return this->Crossings; }
  /// By how much (mm) tools are enlarged for their motion, so that points too are kept apart from
  /// two sheets that cross: a fiftieth of SmallestRadius at a surface that crosses itself, else 0.
  double Margin() const noexcept { return this->CrossesItself() ? 0.02 * this->Smallest : 0.0; }

  /// WedgePlaces for a tool of this radius. The last ones are kept, since every new scene has new
  /// trackers, and the surface and the tool are mostly those of the last. Not for the servo's
  /// thread.
  std::shared_ptr<const WedgePlaces> PlacesFor(double radius, double reach) const;

  /// By the winding number, of a place that this is a near minimum of the distance to.
  bool IsOutside(const Vector3& placeWorld, const ClosestPoint& minimum) const noexcept
  {
    return this->WindingNumberNear(placeWorld, minimum) == 0;
  }
  /// Of a tool that is known to be outside.
  ClosestPoint SeenFromOutside(const ClosestPoint& nearest) const noexcept;
  /// By the winding number: of a tool that is outside, or a place to which a tool that is inside
  /// can be moved out.
  ClosestPoint SeenFrom(const Vector3& queryWorld, const ClosestPoint& nearest) const noexcept;
  /// On the same side of the surface's orientation as another point: of a tool that was pressed
  /// through a thin sheet, that is the side from which it can leave.
  ClosestPoint SeenLike(const ClosestPoint& other, const ClosestPoint& nearest) const noexcept;

  Place PlaceAt(const Vector3& parameter) const noexcept;
  /// With the normal on the side of `like`.
  Place PlaceAt(const Vector3& parameter, const ClosestPoint& like) const noexcept;
  /// The same as a closest point to `queryWorld`, without a search, from which tracking can start;
  /// on the side of `like`.
  ClosestPoint PointAt(const Vector3& parameter, const Vector3& queryWorld,
                       const ClosestPoint& like) const noexcept;

private:
  TouchableSurfaceModel(const SurfaceModel& surface, double smallest);
  int WindingNumberNear(const Vector3& queryWorld, const ClosestPoint& nearest) const noexcept;
  ClosestPoint WayOut(const Vector3& queryWorld, const ClosestPoint& nearest) const noexcept;

  ClosestPointSearchOf<Shape> Closest;
  double Smallest;
  // A point of the surface that borders the outside on the side of the normal.
  struct Exit
  {
    Vector3 Parameter;
    Vector3 PointWorld;
    Vector3 Normal;
  };
  std::vector<Exit> FindExits() const;
  bool IsExit(const Vector3& pointWorld, const Vector3& normal) const noexcept;

  WindingMesh Mesh;
  double MeshDeviation; // of the mesh from the surface, mm
  std::vector<Vector3> Crossings;
  std::vector<Exit> Exits; // of a surface that crosses itself
  mutable std::mutex PlacesLock;
  mutable std::shared_ptr<const WedgePlaces> LastPlaces;
};

/// The same point, seen from the other side of the surface.
TouchableSurfaceModel::ClosestPoint OtherSide(TouchableSurfaceModel::ClosestPoint point) noexcept;
} // namespace palpate
