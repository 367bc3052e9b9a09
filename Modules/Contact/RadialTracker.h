#pragma once

#include "ContactTracker.h"
#include "TouchableRadialModel.h"

#include <memory>

namespace palpate
{
/// The published method: contact where R_probe < R_proxy, with the proxy on the probe's own radius
/// ("Haptic rendering of spherical-harmonic surfaces" of the prostate, on a Falcon). Its force
/// deviates from the true normal by up to atan((a^2 - b^2) / 2ab) on an ellipse. There the probe is
/// a point; here a tool's radius is added to the surface's.
class RadialTracker final : public ContactTracker
{
public:
  RadialTracker(std::shared_ptr<const TouchableRadialModel> surface, double toolRadius);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override;
  bool IsFreeAt(const ToolPose& pose) noexcept override
  {
    const Contact& contact = this->Follow(pose);
    return contact.IsValid && !contact.IsTouching;
  }
  double SurfaceTolerance() const noexcept override { return 2.0 * this->Surface->Rounding(); }
  std::size_t Bytes() const noexcept override { return sizeof(*this); }

private:
  std::shared_ptr<const TouchableRadialModel> Surface;
  double ToolRadius; // mm
  /// Of the last probe; kept at the centre, where the direction is undefined.
  Vector3 Direction = Vector3::UnitZ();
  Contact Felt;
};
} // namespace palpate
