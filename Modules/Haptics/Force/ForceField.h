#pragma once

#include "Vector3.h"

namespace palpate
{
/// A force that depends on the place of the tool's origin alone, with or without contact. It is the
/// negative gradient of a potential, so that a closed path does no work: the energy observer does
/// not see it. It passes all other parts of the safety chain. Immutable, shared by threads.
class ForceField
{
public:
  ForceField() = default;
  virtual ~ForceField() = default;
  ForceField(const ForceField&) = delete;
  ForceField& operator=(const ForceField&) = delete;

  /// N, in the world; continuous. Servo thread: allocates nothing.
  virtual Vector3 ForceWorld(const Vector3& originWorld) const noexcept = 0;
  /// mm; outside, the force is 0.
  virtual Eigen::AlignedBox3d BoundsWorld() const noexcept = 0;
  /// N per mm of the world: about the largest change of the force, which has a bound of stability.
  virtual double Stiffness() const noexcept = 0;
};
} // namespace palpate
