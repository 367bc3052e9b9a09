#pragma once

#include "ClosestPointSearch.h"
#include "Status.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// A star-shaped surface made ready for touch, shared by what follows tools at it. Immutable;
/// queries are noexcept and allocate nothing.
class HarmonicSurface
{
public:
  /// Where a direction from the centre meets the surface.
  struct Place
  {
    Vector3 Direction;  ///< unit vector
    Vector3 PointWorld; ///< mm
    Vector3 Normal;     ///< outward unit normal
  };

  /// Refuses a model whose numbers are not finite, and one whose radius is not positive everywhere.
  /// Takes some milliseconds, allocates.
  static Status Make(std::shared_ptr<const SphericalHarmonicModel> model,
                     std::shared_ptr<const HarmonicSurface>& surface);

  const ClosestPointSearch& Search() const noexcept { return this->Closest; }
  const SphericalHarmonicModel& Model() const noexcept { return this->Closest.Model(); }
  std::size_t Bytes() const noexcept { return sizeof(*this) + this->Closest.Bytes(); }
  /// No radius is smaller or larger, mm.
  double SmallestRadius() const noexcept { return this->Smallest; }
  double LargestRadius() const noexcept { return this->Largest; }
  /// What rounding may leave of a distance next to the surface, mm.
  double Rounding() const noexcept
  {
    return this->Closest.Descent().Rounding(Vector3::Constant(this->Largest));
  }

  Place PlaceAt(const Vector3& direction) const noexcept;
  /// The same as a closest point to `queryWorld` that was not looked for, where tracking can begin.
  ClosestPoint PointAt(const Vector3& direction, const Vector3& queryWorld) const noexcept;

private:
  HarmonicSurface(std::shared_ptr<const SphericalHarmonicModel> model, double smallest,
                  double largest);

  ClosestPointSearch Closest;
  double Smallest;
  double Largest;
};
} // namespace palpate
