#pragma once

#include "Contact.h"
#include "ContactForce.h"

namespace palpate
{
/// Interpolates between the results of a model that is slower than the device: each result is a
/// plane through its proxy, to which every new position of the probe is compared, without a step
/// from one plane to the next.
///
/// If a new result differs from the interpolated one, the difference fades out linearly over one
/// period of the model. All in one frame and mm.
class ForceInterpolation
{
public:
  /// A new result, for `modelProbe`, arrives when the probe is at `probe`; the next one is expected
  /// after `modelPeriod` (s).
  void Renew(const Contact& result, const Vector3& modelProbe, const Vector3& probe,
             double modelPeriod) noexcept;
  /// At the device's tick, `passed` (s) after the last Renew or Advance. Velocity is zero.
  ContactOffset Advance(const Vector3& probe, double passed) noexcept;
  /// No contact, without fading.
  void Reset() noexcept { *this = {}; }

private:
  struct Plane
  {
    bool IsTouching = false;
    Vector3 Proxy = Vector3::Zero();
    Vector3 Normal = Vector3::UnitZ();
    Vector3 Tangential = Vector3::Zero(); // of the offset, due to friction
  };
  static Vector3 OffsetAt(const Plane& plane, const Vector3& probe) noexcept;
  double Remaining() const noexcept;

  Plane Newest;
  Vector3 Difference = Vector3::Zero(); // to be faded out
  Vector3 LastNormal = Vector3::UnitZ();
  double Elapsed = 0.0;
  double Period = 0.0;
};
} // namespace palpate
