#pragma once

#include "Status.h"
#include "Vector3.h"

#include <functional>
#include <vector>

namespace palpate
{
/// What an organ lies on: springs on its surface, isotropic, except where it is free or where
/// something else holds it.
class ElasticBed
{
public:
  static constexpr double DefaultStiffness = 1e-3; ///< N/mm^3

  /// `stiffness` in N/mm^3, not negative.
  explicit ElasticBed(double stiffness = DefaultStiffness) : Stiffness(stiffness) {}

  /// Leaves a cone of directions (rad, from the organ's centre) free; the bed begins over a sixth
  /// of a radian around it.
  void Free(const Vector3& axis, double halfAngle);

  /// Where `part` of a unit direction is 1, `stiffness` (N/mm^3) counts instead of what was told
  /// before, free sides included; between 0 and 1 in part.
  void Hold(std::function<double(const Vector3&)> part, double stiffness);

  /// Fails for a negative or very large stiffness, and for cones that are no cones.
  Status Check() const;

  /// N/mm^3 on the surface in the unit vector `direction` from the centre.
  double At(const Vector3& direction) const;

private:
  struct Cone
  {
    Vector3 Axis;
    double HalfAngle; // rad
  };

  struct Holder
  {
    std::function<double(const Vector3&)> Part;
    double Stiffness; // N/mm^3
  };

  double Stiffness; // N/mm^3
  std::vector<Cone> FreeCones;
  std::vector<Holder> Holders;
};
} // namespace palpate
