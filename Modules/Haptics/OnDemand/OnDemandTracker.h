#pragma once

#include "FieldProxyTracker.h"
#include "OnDemandField.h"

#include <memory>

namespace palpate
{
/// Follows a tool at an on-demand field. Where the newest version covers all that a tick asks, that
/// is felt, with the bits of the whole field, whichever version it is. Where the tool has outrun
/// the bricks the coarse field is felt until they are there: what holds all that the fine one holds
/// lets no tool through. Where the proxy cannot be taken out of the coarse field without passing
/// the fine one it is held where it is.
class OnDemandTracker final : public ContactTracker
{
public:
  OnDemandTracker(std::shared_ptr<OnDemandField> field, const ToolShape& tool,
                  const SurfaceFriction& friction);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override;
  std::size_t Bytes() const noexcept override;

private:
  enum class State
  {
    Nothing, ///< of where the tool was
    Fine,
    Held, ///< at the proxy, until its surroundings are there
    Coarse
  };

  void TakeNewest() noexcept;
  void Begin(const ToolPose& pose) noexcept;
  void FollowFine(const ToolPose& pose) noexcept;
  void FollowHeld(const ToolPose& pose) noexcept;
  void GoOnWithout(const ToolPose& pose) noexcept;
  void FollowCoarse(const ToolPose& pose) noexcept;
  bool Covers(const ToolPose& pose) const noexcept;
  bool GoCoarse(const ToolPose& pose) noexcept;
  void Hold(const ToolPose& pose) noexcept;

  std::shared_ptr<OnDemandField> Field;
  std::shared_ptr<TrackerLink> Link;
  FieldProxyTracker Fine;
  FieldProxyTracker Coarse;
  State Known = State::Nothing;
  ToolPose Last; // up to where the tool was followed
  Contact Felt;
};
} // namespace palpate
