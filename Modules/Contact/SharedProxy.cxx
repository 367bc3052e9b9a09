#include "SharedProxy.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
std::size_t SharedProxy::Add(std::unique_ptr<ToolGaps> gaps)
{
  this->Members.push_back({std::move(gaps), false, 0.0, {}, Vector3::Zero()});
  return this->Members.size() - 1;
}

std::size_t SharedProxy::Bytes() const noexcept
{
  std::size_t bytes = sizeof(*this) + this->Members.size() * sizeof(Member);
  for (const Member& member : this->Members)
  {
    bytes += member.Gaps->Bytes();
  }
  return bytes;
}

void SharedProxy::Begin(const ToolPose& pose, const std::uint32_t* near, std::size_t count) noexcept
{
  this->Proxy.Begin(pose);
  for (Member& member : this->Members)
  {
    member.IsPassed = false;
    member.Part = 0.0;
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
  const ToolWrench lack = hasArrived ? ToolWrench() : this->LackOf(hand);
  double pushes = 0.0;
  for (const PoseConstraint& at : this->Proxy.Constraints())
  {
    pushes += at.Push;
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    this->TakePart(near[n], hasArrived, pushes);
    this->Tell(near[n], hand, hasArrived, lack);
  }
}

// Of a stiffness of 1 N/mm.
ToolWrench SharedProxy::LackOf(const ToolPose& hand) const noexcept
{
  ToolWrench lack = this->Proxy.WrenchOn(hand, 1.0);
  for (const PoseConstraint& at : this->Proxy.Constraints())
  {
    lack.Force -= at.Shift();
    lack.Torque -= at.Arm.cross(at.Shift());
  }
  return lack;
}

void SharedProxy::TakePart(std::size_t structure, bool hasArrived, double pushes) noexcept
{
  double& part = this->Members[structure].Part;
  if (pushes > 0.0)
  {
    double own = 0.0;
    for (const PoseConstraint& at : this->Proxy.Constraints())
    {
      own += at.Owner == structure ? at.Push : 0.0;
    }
    part = own / pushes;
  }
  else if (hasArrived)
  {
    part = 0.0;
  }
}

void SharedProxy::Tell(std::size_t structure, const ToolPose& hand, bool hasArrived,
                       const ToolWrench& lack) noexcept
{
  constexpr double Cancelled = 0.05; // of all pushes
  const double part = this->Members[structure].Part;
  Contact& share = this->Members[structure].Share;
  Vector3 offset = part * lack.Force;
  Vector3 foot = Vector3::Zero();
  Vector3 pushes = Vector3::Zero();
  double push = 0.0;
  const PoseConstraint* strongest = nullptr;
  share.Turn = part * lack.Torque;
  Vector3& cut = this->Members[structure].CutOffset;
  cut.setZero();
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
      cut += at.Cuts ? at.Shift() : Vector3::Zero();
    }
  }
  share.IsValid = true;
  share.IsBehind = !hasArrived;
  share.IsTouching = part > 0.0;
  share.HasFoot = share.IsTouching;
  share.ProxyWorld = hand.PositionWorld + offset;
  share.Depth = offset.norm();
  if (strongest != nullptr) // else the last one's
  {
    const bool isOneSide = pushes.norm() > Cancelled * push;
    share.NormalWorld = isOneSide ? Vector3(pushes.normalized()) : strongest->Normal;
    share.FootWorld = foot / push;
  }
}
} // namespace palpate
