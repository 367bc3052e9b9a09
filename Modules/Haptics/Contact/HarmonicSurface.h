#pragma once

#include "ClosestPointSearch.h"
#include "Status.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// A star-shaped surface prepared for touch, shared by its trackers. Immutable; queries are
/// noexcept and do not allocate.
class HarmonicSurface
{
public:
  /// A point of the surface, by its direction from the centre.
  struct Place
  {
    Vector3 Direction;  ///< unit vector
    Vector3 PointWorld; ///< mm
    Vector3 Normal;     ///< outward unit normal
  };

  /// Fails for a model with numbers that are not finite, and for one whose radius is not positive
  /// everywhere. Takes some milliseconds, allocates.
  static Status Make(std::shared_ptr<const SphericalHarmonicModel> model,
                     std::shared_ptr<const HarmonicSurface>& surface);

  const ClosestPointSearch& Search() const noexcept { return this->Closest; }
  const SphericalHarmonicModel& Model() const noexcept { return this->Closest.Model(); }
  std::size_t Bytes() const noexcept { return sizeof(*this) + this->Closest.Bytes(); }
  /// Bounds of the radius, mm.
  double SmallestRadius() const noexcept { return this->Smallest; }
  double LargestRadius() const noexcept { return this->Largest; }
  /// Rounding error of a distance near the surface, mm.
  double Rounding() const noexcept
  {
    return this->Closest.Descent().Rounding(Vector3::Constant(this->Largest));
  }

  Place PlaceAt(const Vector3& direction) const noexcept;
  /// The same as a closest point to `queryWorld`, without a search, from which tracking can start.
  ClosestPoint PointAt(const Vector3& direction, const Vector3& queryWorld) const noexcept;

private:
  HarmonicSurface(std::shared_ptr<const SphericalHarmonicModel> model, double smallest,
                  double largest);

  ClosestPointSearch Closest;
  double Smallest;
  double Largest;
};
} // namespace palpate
