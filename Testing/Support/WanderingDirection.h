#pragma once

#include "RandomShapes.h"

#include <Eigen/Geometry>

namespace palpate::test
{
/// A random unit vector that moves over the sphere along a great circle that slowly turns.
class WanderingDirection
{
public:
  explicit WanderingDirection(Random& random)
      : Source(random), Place(RandomDirection(random)), Axis(RandomDirection(random))
  {
  }

  const Vector3& Current() const noexcept { return this->Place; }
  /// The next one, at most this angle (rad) away.
  const Vector3& Next(double angle)
  {
    this->Axis = (this->Axis + 0.05 * RandomDirection(this->Source)).normalized();
    this->Place = (Eigen::AngleAxisd(angle, this->Axis) * this->Place).normalized();
    return this->Place;
  }

private:
  Random& Source;
  Vector3 Place;
  Vector3 Axis;
};
} // namespace palpate::test
