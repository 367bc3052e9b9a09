#pragma once

#include "OnDemandHarmonics.h"

#include <memory>

namespace palpate
{
/// Follows a tool at an on-demand structure of spherical harmonics, while that is at hand, with the
/// bits of the model's own tracker. While it is not there is nothing to be felt: within reach the
/// contact is invalid, and who follows the tool feels the coarse body.
class OnDemandHarmonicTracker final : public ContactTracker
{
public:
  OnDemandHarmonicTracker(std::shared_ptr<OnDemandHarmonics> harmonics,
                          std::shared_ptr<TrackerSlot> slot, double toolRadius);
  ~OnDemandHarmonicTracker() override { this->Rest(); }
  OnDemandHarmonicTracker(const OnDemandHarmonicTracker&) = delete;
  OnDemandHarmonicTracker& operator=(const OnDemandHarmonicTracker&) = delete;

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override;
  bool IsAtHand() noexcept override;
  void Rest() noexcept override;
  std::size_t Bytes() const noexcept override { return sizeof(*this) + sizeof(TrackerSlot); }

private:
  bool Hold() noexcept;

  std::shared_ptr<OnDemandHarmonics> Harmonics; // as long as somebody may hold what is its
  std::shared_ptr<TrackerSlot> Slot;
  Eigen::AlignedBox3d Reach; // mm, of the tool's centre
  ContactTracker* Held = nullptr;
  bool Touches = false;
  Contact Nothing;
};
} // namespace palpate
