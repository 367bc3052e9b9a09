#include "SharedProxy.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
std::size_t SharedProxy::Add(std::unique_ptr<ToolGaps> gaps)
{
  this->Members.push_back({std::move(gaps), false, {}});
  return this->Members.size() - 1;
}

void SharedProxy::Begin(const ToolPose& pose, const std::uint32_t* near, std::size_t count) noexcept
{
  this->Proxy.Begin(pose);
  for (Member& member : this->Members)
  {
    member.IsPassed = false;
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    Member& member = this->Members[near[n]];
    member.IsPassed = !member.Gaps->IsFreeAt(pose);
  }
}

void SharedProxy::Follow(const ToolPose& hand, const std::uint32_t* near,
                         std::size_t count) noexcept
{
  if (!hand.IsUsable())
  {
    std::for_each(near, near + count,
                  [&](std::uint32_t structure) { this->Members[structure].Share = Contact(); });
    return;
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    Member& member = this->Members[near[n]];
    member.Gaps->BeginTick();
    member.IsPassed = member.IsPassed && !member.Gaps->IsFreeAt(this->Proxy.Pose());
  }
  const auto gather = [&](const ToolPose& pose, PoseConstraints& limits)
  {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t n = 0; n < count; ++n)
    {
      const Member& member = this->Members[near[n]];
      if (!member.IsPassed)
      {
        limits.SetOwner(near[n]);
        nearest = std::min(nearest, member.Gaps->Gather(pose, limits));
      }
    }
    return nearest;
  };
  const bool hasArrived = this->Proxy.Follow(hand, gather);
  for (std::size_t n = 0; n < count; ++n)
  {
    this->Tell(near[n], hand, hasArrived);
  }
}

void SharedProxy::Tell(std::size_t structure, const ToolPose& hand, bool hasArrived) noexcept
{
  constexpr double Cancelled = 0.05; // of all pushes
  Contact& share = this->Members[structure].Share;
  Vector3 offset = Vector3::Zero();
  Vector3 foot = Vector3::Zero();
  Vector3 pushes = Vector3::Zero();
  double push = 0.0;
  const PoseConstraint* strongest = nullptr;
  share.Turn.setZero();
  for (const PoseConstraint& at : this->Proxy.Constraints())
  {
    if (at.Owner == structure && at.Push > 0.0)
    {
      strongest = strongest == nullptr || at.Push > strongest->Push ? &at : strongest;
      push += at.Push;
      pushes += at.Push * at.Normal;
      offset += at.Shift();
      foot += at.Push * (this->Proxy.Pose().PositionWorld + at.Arm);
      share.Turn += at.Arm.cross(at.Shift());
    }
  }
  share.IsValid = true;
  share.IsBehind = !hasArrived;
  share.IsTouching = strongest != nullptr;
  share.HasFoot = share.IsTouching;
  share.ProxyWorld = hand.PositionWorld + offset;
  share.Depth = offset.norm();
  if (share.IsTouching)
  {
    const bool isOneSide = pushes.norm() > Cancelled * push;
    share.NormalWorld = isOneSide ? Vector3(pushes.normalized()) : strongest->Normal;
    share.FootWorld = foot / push;
  }
}
} // namespace palpate
