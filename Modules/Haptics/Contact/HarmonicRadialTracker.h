#pragma once

#include "ContactTracker.h"
#include "HarmonicSurface.h"

#include <memory>

namespace palpate
{
/// The published law: contact where R_probe < R_proxy, with the proxy on the probe's own radius
/// ("Haptic rendering of spherical-harmonic surfaces" of the prostate, on a Falcon). Its force is
/// off the true normal by up to atan((a^2 - b^2) / 2ab) on an ellipse. The probe is a point there;
/// a tool's radius is added to the surface's here.
class HarmonicRadialTracker final : public ContactTracker
{
public:
  HarmonicRadialTracker(std::shared_ptr<const HarmonicSurface> surface, double toolRadius);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override;
  std::size_t Bytes() const noexcept override { return sizeof(*this); }

private:
  std::shared_ptr<const HarmonicSurface> Surface;
  double ToolRadius; // mm
  /// Of the last probe: in the centre, which has no radius of its own, the last one goes on.
  Vector3 Direction = Vector3::UnitZ();
  Contact Felt;
};
} // namespace palpate
