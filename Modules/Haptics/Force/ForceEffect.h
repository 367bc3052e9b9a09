#pragma once

#include "ContactForce.h"
#include "ForceField.h"
#include "Status.h"
#include "Vector3.h"

#include <cstddef>

namespace palpate
{
/// A touched structure in one tick, for its force effects. In the device's frame, unless World.
struct EffectTouch
{
  ContactOffset Contact;
  Vector3 ContactForce = Vector3::Zero(); ///< N
  Vector3 HandVelocity = Vector3::Zero(); ///< mm/s
  /// mm; the tool's centre is inside where the contact is deeper than this.
  double CenterDepth = 0.0;
  double OwnStiffness = 0.0;                    ///< N/mm, of the structure without effects
  Vector3 SurfaceWorld = Vector3::Zero();       ///< mm, where the tool touches
  Matrix3 WorldPerDevice = Matrix3::Identity(); ///< mm of the world per mm of the hand
  double Time = 0.0;                            ///< s
};

/// A force that a structure adds to its contact force, or a change of its stiffness. Immutable,
/// shared by threads.
class ForceEffect
{
public:
  ForceEffect() = default;
  virtual ~ForceEffect() = default;
  ForceEffect(const ForceEffect&) = delete;
  ForceEffect& operator=(const ForceEffect&) = delete;

  /// N, in the device's frame. Servo thread: allocates nothing.
  virtual Vector3 Force(const EffectTouch& /*touch*/) const noexcept { return Vector3::Zero(); }
  /// A force that acts around the structure, with or without contact; null: none.
  virtual const ForceField* Field() const noexcept { return nullptr; }
  /// N/mm at the hand: the stiffness of a rigid structure where the tool touches `pointWorld` (mm),
  /// if it would be `own` without this effect. Servo thread: allocates nothing.
  virtual double StiffnessAt(double own, const Vector3& /*pointWorld*/) const noexcept
  {
    return own;
  }
  /// The largest of these anywhere, which has a bound of stability.
  virtual double LargestStiffness(double own) const noexcept { return own; }
  /// N s/mm that it adds to the damping of the contact, which has a bound of stability.
  virtual double Damping() const noexcept { return 0.0; }
  /// Refuses parameters that give no finite force.
  virtual Status Check() const { return Status::Success(); }
  virtual std::size_t Bytes() const noexcept { return 0; }
};
} // namespace palpate
