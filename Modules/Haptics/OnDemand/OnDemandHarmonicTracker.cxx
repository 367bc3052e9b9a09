#include "OnDemandHarmonicTracker.h"

#include <utility>

namespace palpate
{
OnDemandHarmonicTracker::OnDemandHarmonicTracker(std::shared_ptr<OnDemandHarmonics> harmonics,
                                                 std::shared_ptr<TrackerSlot> slot,
                                                 double toolRadius)
    : Harmonics(std::move(harmonics)), Slot(std::move(slot)), Reach(Harmonics->BoundsWorld())
{
  this->Reach.min().array() -= toolRadius;
  this->Reach.max().array() += toolRadius;
}

bool OnDemandHarmonicTracker::Hold() noexcept
{
  if (this->Held == nullptr)
  {
    this->Held = this->Slot->Hold();
    if (this->Held != nullptr)
    {
      this->Held->Release();
    }
  }
  return this->Held != nullptr;
}

// What is touched is never given back.
bool OnDemandHarmonicTracker::IsAtHand() noexcept
{
  if (this->Held != nullptr && !this->Touches && this->Slot->IsAskedBack())
  {
    this->Rest();
  }
  return this->Hold();
}

void OnDemandHarmonicTracker::Rest() noexcept
{
  if (this->Held != nullptr)
  {
    this->Held = nullptr;
    this->Touches = false;
    this->Slot->GiveBack();
  }
}

void OnDemandHarmonicTracker::Release() noexcept
{
  this->Touches = false;
  if (this->Held != nullptr)
  {
    this->Held->Release();
  }
}

const Contact& OnDemandHarmonicTracker::Follow(const ToolPose& pose) noexcept
{
  if (this->Hold())
  {
    const Contact& felt = this->Held->Follow(pose);
    this->Touches = felt.IsTouching;
    return felt;
  }
  this->Nothing = Contact();
  if (pose.IsUsable())
  {
    this->Nothing.ProxyWorld = pose.PositionWorld;
    this->Nothing.IsValid = !this->Reach.contains(pose.PositionWorld);
  }
  return this->Nothing;
}
} // namespace palpate
