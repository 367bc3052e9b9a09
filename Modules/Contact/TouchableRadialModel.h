#pragma once

#include "ClosestPointSearch.h"
#include "Status.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// A radial model prepared for touch, shared by its trackers. Immutable; queries are
/// noexcept and do not allocate.
class TouchableRadialModel
{
public:
  using Shape = RadialModel;
  using ClosestPoint = ClosestPointOf<Shape>;
  static constexpr bool MayCrossItself = false;
  /// Evaluations in a tick: of searches of the whole surface alone, or of all work.
  static constexpr int EvaluationsOfTick() noexcept { return 500; }
  static constexpr bool CountsAllWork = false;

  /// A point of the surface, by its direction from the centre.
  struct Place
  {
    Vector3 Direction;  ///< unit vector
    Vector3 PointWorld; ///< mm
    Vector3 Normal;     ///< outward unit normal
  };

  /// Fails for a model with numbers that are not finite, and for one whose radius is not positive
  /// everywhere. Takes some milliseconds, allocates.
  static Status Make(std::shared_ptr<const RadialModel> model,
                     std::shared_ptr<const TouchableRadialModel>& surface);

  const ClosestPointSearch& Search() const noexcept { return this->Closest; }
  const RadialModel& Model() const noexcept { return this->Closest.Model(); }
  std::size_t Bytes() const noexcept { return sizeof(*this) + this->Closest.Bytes(); }
  /// Bounds of the radius, mm.
  double SmallestRadius() const noexcept { return this->Smallest; }
  double LargestRadius() const noexcept { return this->Largest; }
  Eigen::AlignedBox3d BoundsWorld() const noexcept
  {
    const Vector3 reach = Vector3::Constant(this->Largest);
    return {this->Model().CenterWorld() - reach, this->Model().CenterWorld() + reach};
  }
  /// Rounding error of a distance near the surface, mm.
  double Rounding() const noexcept
  {
    return this->Closest.Descent().Rounding(Vector3::Constant(this->Largest));
  }

  Place PlaceAt(const Vector3& direction) const noexcept;
  /// The same as a closest point to `queryWorld`, without a search, from which tracking can start.
  ClosestPoint PointAt(const Vector3& direction, const Vector3& queryWorld) const noexcept;

  /// What only surfaces need that may cross themselves; see TouchableSurfaceModel.
  static constexpr bool CrossesItself() noexcept { return false; }
  static constexpr double Margin() noexcept { return 0.0; }
  static bool IsOutside(const Vector3&, const ClosestPoint&) noexcept { return true; }
  static const ClosestPoint& SeenFromOutside(const ClosestPoint& point) noexcept { return point; }
  static const ClosestPoint& SeenFrom(const Vector3&, const ClosestPoint& point) noexcept
  {
    return point;
  }
  static const ClosestPoint& SeenLike(const ClosestPoint&, const ClosestPoint& point) noexcept
  {
    return point;
  }
  Place PlaceAt(const Vector3& direction, const ClosestPoint&) const noexcept
  {
    return this->PlaceAt(direction);
  }
  ClosestPoint PointAt(const Vector3& direction, const Vector3& queryWorld,
                       const ClosestPoint&) const noexcept
  {
    return this->PointAt(direction, queryWorld);
  }

private:
  TouchableRadialModel(std::shared_ptr<const RadialModel> model, double smallest, double largest);

  ClosestPointSearch Closest;
  double Smallest;
  double Largest;
};
} // namespace palpate
