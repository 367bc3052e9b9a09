#pragma once

#include "ContactForce.h"
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
  Vector3 SurfaceWorld = Vector3::Zero(); ///< mm, where the tool touches
  double Time = 0.0;                      ///< s
};

/// A force that a structure adds to its contact force. Immutable, shared by threads.
class ForceEffect
{
public:
  ForceEffect() = default;
  virtual ~ForceEffect() = default;
  ForceEffect(const ForceEffect&) = delete;
  ForceEffect& operator=(const ForceEffect&) = delete;

  /// N, in the device's frame. Servo thread: allocates nothing.
  virtual Vector3 Force(const EffectTouch& touch) const noexcept = 0;
  /// N s/mm that it adds to the damping of the contact, which has a bound of stability.
  virtual double Damping() const noexcept { return 0.0; }
  /// Refuses parameters that give no finite force.
  virtual Status Check() const { return Status::Success(); }
  virtual std::size_t Bytes() const noexcept { return 0; }
};
} // namespace palpate
