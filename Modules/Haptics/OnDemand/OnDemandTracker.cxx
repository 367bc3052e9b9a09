#include "OnDemandTracker.h"

#include <utility>

namespace palpate
{
OnDemandTracker::OnDemandTracker(std::shared_ptr<OnDemandField> field, const ToolShape& tool,
                                 const SurfaceFriction& friction)
    : Field(std::move(field)), Link(this->Field->Attach()),
      Fine(this->Field->Newest(), tool, friction), Coarse(this->Field->Coarse(), tool, friction)
{
  this->TakeNewest();
}

// The slot keeps what it hands out until the next one is taken, and then sends it back to be
// destroyed: what is followed owns nothing.
void OnDemandTracker::TakeNewest() noexcept
{
  if (this->Link->Versions.Refresh())
  {
    std::shared_ptr<const FieldSolid> solid(std::shared_ptr<const FieldSolid>(),
                                            this->Link->Versions.Current()->Solid.get());
    this->Fine.Exchange(solid);
  }
}

std::size_t OnDemandTracker::Bytes() const noexcept
{
  return sizeof(*this) - sizeof(this->Fine) - sizeof(this->Coarse) + this->Fine.Bytes() +
         this->Coarse.Bytes();
}

void OnDemandTracker::Release() noexcept
{
  this->Link->ProxyPull.Publish({});
  this->Known = State::Nothing;
  this->Fine.Release();
  this->Coarse.Release();
}

const Contact& OnDemandTracker::Follow(const ToolPose& pose) noexcept
{
  this->TakeNewest();
  if (!pose.IsUsable())
  {
    this->Felt.IsValid = false;
    this->Felt.IsTouching = false;
    return this->Felt;
  }
  switch (this->Known)
  {
  case State::Nothing:
    this->Begin(pose);
    break;
  case State::Fine:
    this->FollowFine(pose);
    break;
  case State::Held:
    this->FollowHeld(pose);
    break;
  case State::Coarse:
    this->FollowCoarse(pose);
    break;
  }
  this->Link->ProxyPull.Publish(this->Felt.ProxyWorld - pose.PositionWorld);
  return this->Felt;
}

// Whether all is known that a tick asks which leads the tool there.
bool OnDemandTracker::Covers(const ToolPose& pose) const noexcept
{
  const FieldSolid& solid = this->Fine.Followed();
  const double reach = this->Fine.AskedReach();
  return solid.Covers(pose.PositionWorld, reach) && solid.Covers(this->Felt.ProxyWorld, reach) &&
         solid.Covers(this->Last.PositionWorld, reach);
}

// A tool that begins inside is put out by the coarse field, which knows all ways out.
void OnDemandTracker::Begin(const ToolPose& pose) noexcept
{
  this->Last = pose;
  this->Felt.ProxyWorld = pose.PositionWorld;
  if (this->Covers(pose))
  {
    this->Fine.Release();
    this->Felt = this->Fine.Follow(pose);
    this->Known = State::Fine;
  }
  if (this->Known == State::Nothing || !this->Fine.IsFree())
  {
    this->Coarse.Release();
    this->Felt = this->Coarse.Follow(pose);
    this->Known = State::Coarse;
    this->Field->CountCoarseTick();
  }
  this->Felt.Material = this->Fine.Followed().Material();
}

void OnDemandTracker::FollowFine(const ToolPose& pose) noexcept
{
  const Contact before = this->Felt;
  if (this->Covers(pose))
  {
    this->Felt = this->Fine.Follow(pose);
    if (this->Covers(pose))
    {
      this->Last = pose;
      return;
    }
    // The proxy went where nothing is known: that tick did not happen.
    this->Felt = before;
  }
  this->GoOnWithout(pose);
}

// Begins again where it was held.
void OnDemandTracker::FollowHeld(const ToolPose& pose) noexcept
{
  if (!this->Covers(pose))
  {
    this->GoOnWithout(pose);
    return;
  }
  this->Fine.Release();
  this->Fine.Follow({this->Felt.ProxyWorld, pose.Orientation});
  this->Known = State::Fine;
  this->FollowFine(pose);
}

// Where bricks are missing.
void OnDemandTracker::GoOnWithout(const ToolPose& pose) noexcept
{
  this->Field->CountCoarseTick();
  if (!this->GoCoarse(pose))
  {
    this->Hold(pose);
  }
}

// Takes the proxy out of the coarse field, and then to the probe.
bool OnDemandTracker::GoCoarse(const ToolPose& pose) noexcept
{
  const Vector3 from = this->Felt.ProxyWorld;
  this->Coarse.Release();
  const Vector3 to = this->Coarse.Follow({from, pose.Orientation}).ProxyWorld;
  const double reach = this->Fine.AskedReach();
  const FieldSolid& solid = this->Fine.Followed();
  if (!solid.Covers(from, reach) || !solid.Covers(to, reach) ||
      (to != from && !this->Fine.IsWayFree(from, to - from)))
  {
    return false;
  }
  this->Felt = this->Coarse.Follow(pose);
  this->Felt.Material = solid.Material();
  this->Last = pose;
  this->Known = State::Coarse;
  return true;
}

void OnDemandTracker::Hold(const ToolPose& pose) noexcept
{
  const Vector3 back = this->Felt.ProxyWorld - pose.PositionWorld;
  const double depth = back.norm();
  if (!this->Felt.IsTouching && depth > 0.0)
  {
    this->Felt.NormalWorld = back / depth;
  }
  this->Felt.IsValid = true;
  this->Felt.IsTouching = depth > 0.0;
  this->Felt.Depth = depth;
  this->Last = {this->Felt.ProxyWorld, pose.Orientation};
  this->Known = State::Held;
}

// The coarse proxy is outside the coarse field, so outside the fine one: that is where it goes on.
void OnDemandTracker::FollowCoarse(const ToolPose& pose) noexcept
{
  if (this->Covers(pose))
  {
    const ToolPose start{this->Felt.ProxyWorld, pose.Orientation};
    this->Fine.Release();
    this->Fine.Follow(start);
    if (this->Fine.IsFree())
    {
      this->Felt = this->Fine.Follow(pose);
      this->Last = pose;
      this->Known = State::Fine;
      return;
    }
  }
  this->Field->CountCoarseTick();
  this->Felt = this->Coarse.Follow(pose);
  this->Felt.Material = this->Fine.Followed().Material();
  this->Last = pose;
}
} // namespace palpate
