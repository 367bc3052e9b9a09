#pragma once

#include "Contact.h"
#include "ContactForce.h"

namespace palpate
{
/// What is felt between the results of a model that is slower than the device, as the first paper
/// wished for: each result stands for a plane through its proxy, against which every new position
/// of the probe is taken, and from one plane to the next there is no step.
///
/// Where a new result differs from what was felt, the difference fades out linearly over one period
/// of the model. All in one frame and mm.
class ForceInterpolation
{
public:
  /// A new result, of the model for `modelProbe`, arrives when the probe has got to `probe`; until
  /// the next one about `modelPeriod` (s) will pass.
  void Renew(const Contact& result, const Vector3& modelProbe, const Vector3& probe,
             double modelPeriod) noexcept;
  /// At the device's tick, `passed` (s) after the last Renew or Advance. Velocity is left zero.
  ContactOffset Advance(const Vector3& probe, double passed) noexcept;
  /// Nothing is touched, without fading.
  void Reset() noexcept { *this = {}; }

private:
  struct Plane
  {
    bool IsTouching = false;
    Vector3 Proxy = Vector3::Zero();
    Vector3 Normal = Vector3::UnitZ();
    Vector3 Tangential = Vector3::Zero(); // of the offset: friction's
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
