#include "StructureFollower.h"

#include "VolumeViscosity.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// No tool is this far (mm) from where it should be, but for a failed computation.
constexpr double LargestDepth = 1e4;

// A contact that a force may be made of; every comparison fails for NaN.
bool IsSound(const Contact& contact, const Vector3& probeWorld) noexcept
{
  if (!contact.IsValid)
  {
    return false;
  }
  const double normal = contact.NormalWorld.squaredNorm();
  return !contact.IsTouching || ((contact.ProxyWorld - probeWorld).norm() <= LargestDepth &&
                                 normal >= 0.99 && normal <= 1.01);
}

double LeastRadius(const ToolShape& tool)
{
  double least = tool.BoundingRadius();
  for (const Vector3& point : tool.Points())
  {
    least = std::min(least, point.norm());
  }
  return least;
}

// s; no tick feeds a drill for longer.
constexpr double LongestFeed = 0.01;

Contact Untouched(const Vector3& probeWorld) noexcept
{
  Contact contact;
  contact.ProxyWorld = probeWorld;
  contact.IsValid = true;
  return contact;
}
} // namespace

StructureFollower::StructureFollower(const TouchStructure& structure, const TouchScene& scene,
                                     double velocityTimeConstant,
                                     std::vector<std::unique_ptr<ContactTracker>> trackers)
    : Trackers(std::move(trackers)), Structure(&structure), Frame(&scene.Frame), Tool(&scene.Drill),
      Reach(ReachWorld(structure, scene.Tool)), ToolRadiusWorld(LeastRadius(scene.Tool)),
      ToolRadiusDevice(scene.Frame.LengthDevice(ToolRadiusWorld * Vector3::UnitX()).norm()),
      OffsetVelocity(velocityTimeConstant)
{
  if (structure.Site >= 0)
  {
    this->Drilled = dynamic_cast<FieldProxyTracker*>(this->Trackers.front().get());
    this->Feed = std::make_unique<DrillFeed>(scene.Drill.Motion.Radius, scene.Drill.Clearance);
  }
}

Eigen::AlignedBox3d StructureFollower::ReachWorld(const TouchStructure& structure,
                                                  const ToolShape& tool)
{
  Eigen::AlignedBox3d reach = structure.Model->BoundsWorld();
  for (const TouchStandIn& coarser : structure.Coarser)
  {
    reach.extend(coarser.Model->BoundsWorld());
  }
  reach.min().array() -= tool.BoundingRadius();
  reach.max().array() += tool.BoundingRadius();
  return reach;
}

Status StructureFollower::Make(const TouchStructure& structure, const TouchScene& scene,
                               double velocityTimeConstant,
                               std::vector<StructureFollower>& followers)
{
  std::vector<std::unique_ptr<ContactTracker>> trackers(1 + structure.Coarser.size());
  for (std::size_t rung = 0; rung < trackers.size(); ++rung)
  {
    const TouchStandIn* coarser = rung > 0 ? &structure.Coarser[rung - 1] : nullptr;
    const ContactModel& model = coarser != nullptr ? *coarser->Model : *structure.Model;
    const ToolShape& tool = coarser != nullptr && coarser->Tool ? *coarser->Tool : scene.Tool;
    const Status status = model.MakeTracker(tool, structure.Friction, trackers[rung]);
    if (!status.IsOk())
    {
      return Status::Failure("The structure " + structure.Name +
                             " cannot be touched: " + status.Message());
    }
  }
  if (structure.Site >= 0 && dynamic_cast<FieldProxyTracker*>(trackers.front().get()) == nullptr)
  {
    return Status::Failure("The structure " + structure.Name +
                           " cannot be drilled, since it is not felt by a field's proxy.");
  }
  Status status = Status::Success();
  if (structure.Beneath != nullptr)
  {
    trackers.emplace_back();
    status = structure.Beneath->MakeTracker(scene.Tool, structure.Friction, trackers.back());
  }
  if (status.IsOk())
  {
    followers.push_back(
        StructureFollower(structure, scene, velocityTimeConstant, std::move(trackers)));
  }
  return status;
}

std::size_t StructureFollower::Bytes() const noexcept
{
  std::size_t bytes = sizeof(*this) + this->Trackers.size() * sizeof(this->Trackers[0]) +
                      (this->Feed != nullptr ? sizeof(DrillFeed) : 0);
  for (const auto& tracker : this->Trackers)
  {
    bytes += tracker->Bytes();
  }
  return bytes;
}

// What a level asks for, or what lies beneath where that is not at hand.
std::size_t StructureFollower::RungOf(int level) noexcept
{
  const std::size_t most = this->Structure->Coarser.size();
  const std::size_t rung = std::min(static_cast<std::size_t>(std::max(level, 0)), most);
  const bool isThere = !this->HasBeneath() || this->Trackers[rung]->IsAtHand();
  return isThere ? rung : most + 1;
}

bool StructureFollower::IsInReach(const FollowStep& step) const noexcept
{
  return step.WayWorld().intersects(this->Reach);
}

void StructureFollower::Leave() noexcept
{
  this->Tracker().Rest();
  this->Follows = false;
  this->IsBuried = false;
  this->Before.reset();
  this->Weight = RampIn(0.0);
  this->Force.setZero();
  this->OffsetVelocity.Reset();
  this->Interpolation.Reset();
  if (this->Feed != nullptr)
  {
    this->Feed->Leave();
  }
}

void StructureFollower::CarryOn(const StructureFollower& before) noexcept
{
  this->Before = before.Last;
  if (this->Feed != nullptr && before.Feed != nullptr)
  {
    *this->Feed = *before.Feed;
  }
}

const Contact& StructureFollower::BeginAt(const Vector3& placeWorld,
                                          const FollowStep& step) noexcept
{
  this->OffsetVelocity.Reset();
  this->Tracker().Release();
  return this->Tracker().Follow({placeWorld, step.Now.Orientation});
}

// What is exchanged owns nothing: who gives solids keeps them.
void StructureFollower::UseSolid(const FieldSolid& solid, std::uint64_t version) noexcept
{
  std::shared_ptr<const FieldSolid> next(std::shared_ptr<const FieldSolid>(), &solid);
  this->Drilled->Exchange(next);
  this->Feed->Arrive(version);
}

bool StructureFollower::BeginAgain(const FollowStep& step) noexcept
{
  if (this->Follows)
  {
    this->Feed->Leave();
    // A proxy on the surface may be a little inside.
    constexpr double OutInVoxels = 0.5;
    const double out =
        this->Last.IsTouching ? OutInVoxels * this->Drilled->Followed().VoxelSize() : 0.0;
    const Vector3 place = this->Last.ProxyWorld + out * this->Last.NormalWorld;
    this->Tracker().Release();
    this->IsBuried = !this->Drilled->IsFreeAt({place, step.Now.Orientation});
    if (!this->IsBuried)
    {
      this->BeginAt(place, step);
    }
    this->Weight = RampIn(this->Last.IsTouching ? HandoverDuration : 0.0);
  }
  return this->Follows;
}

void StructureFollower::Unbury(const FollowStep& step) noexcept
{
  this->IsBuried = !this->Drilled->IsFreeAt(step.Now);
  if (!this->IsBuried)
  {
    this->BeginAt(step.Now.PositionWorld, step);
  }
  this->Interpolation.Reset();
}

bool StructureFollower::NextCut(CutOrder& order) noexcept
{
  order.Site = this->Structure->Site;
  order.Tool = this->Tool->Tool;
  return this->Feed->NextCut(order);
}

bool StructureFollower::UseLevel(const FollowStep& step) noexcept
{
  const std::size_t rung = this->Follows ? this->RungOf(step.Level) : this->Rung;
  if (rung == this->Rung)
  {
    return false;
  }
  this->Tracker().Rest();
  this->Rung = rung;
  const Contact& begun = this->BeginAt(this->Last.ProxyWorld, step);
  this->Weight = RampIn(this->Last.IsTouching || begun.IsTouching ? HandoverDuration : 0.0);
  return true;
}

FadingContact StructureFollower::FadingOut(const Vector3& hand) const noexcept
{
  return {this->Force, this->NormalDevice, this->Factor * this->Structure->Law.Stiffness, hand};
}

// A tracker that was left while out of reach begins anew at the place before this tick, which was
// out of reach too. So it never takes the way round a structure for a way through it.
void StructureFollower::Enter(const FollowStep& step) noexcept
{
  ToolPose from = step.Last;
  this->Weight = RampIn(step.FadeIn);
  if (step.FadeIn > 0.0 && this->Before && this->Before->IsValid)
  {
    from = {this->Before->ProxyWorld, step.Now.Orientation};
    this->Weight = this->Before->IsTouching ? RampIn(HandoverDuration) : this->Weight;
  }
  else
  {
    this->OffsetVelocity.Update(Vector3::Zero(), step.Passed);
  }
  this->Rung = this->RungOf(step.Level);
  if (this->HasBeneath() && this->Rung > this->Structure->Coarser.size())
  {
    // It reaches farther than what it holds, so the tool may be in it.
    this->Weight = RampIn(HandoverDuration);
  }
  this->Tracker().Release();
  this->Tracker().Follow(from);
  this->Before.reset();
  this->Follows = true;
}

void StructureFollower::AskModel(const FollowStep& step) noexcept
{
  this->Last = this->Tracker().Follow(step.Now);
  this->Last.IsValid = IsSound(this->Last, step.Now.PositionWorld);
  this->Last.IsTouching = this->Last.IsTouching && this->Last.IsValid;
}

ContactOffset StructureFollower::Felt(const FollowStep& step) noexcept
{
  const Vector3& probe = step.Now.PositionWorld;
  const bool isInterpolated = step.ModelPeriod > 0.0;
  ContactOffset felt;
  if (isInterpolated)
  {
    felt = this->Interpolation.Advance(probe, step.Passed);
  }
  if (step.AsksModel)
  {
    this->AskModel(step);
    felt.IsTouching = this->Last.IsTouching;
    felt.Normal = this->Last.NormalWorld;
    felt.Offset = felt.IsTouching ? Vector3(this->Last.ProxyWorld - probe) : Vector3::Zero();
  }
  if (step.AsksModel && isInterpolated)
  {
    this->Interpolation.Renew(this->Last, probe, probe, step.ModelPeriod);
    felt = this->Interpolation.Advance(probe, 0.0);
  }
  return felt;
}

Vector3 StructureFollower::Follow(const FollowStep& step) noexcept
{
  if (step.AsksModel && this->IsInReach(step) != this->Follows)
  {
    this->Follows ? this->Leave() : this->Enter(step);
  }
  if (this->Follows && this->IsBuried && step.AsksModel)
  {
    this->Unbury(step);
  }
  if (!this->Follows || this->IsBuried)
  {
    this->Last = Untouched(step.Now.PositionWorld);
    this->Force.setZero();
    return Vector3::Zero();
  }
  ContactOffset felt = this->Felt(step);
  if (this->Feed != nullptr && felt.IsTouching)
  {
    felt.Offset = this->Feed->Meet(step.Now, felt.Offset, this->IsCut(step));
  }
  const Vector3 proxyWorld = step.Now.PositionWorld + felt.Offset;
  felt.Offset = this->Frame->LengthDevice(felt.Offset);
  felt.Normal = this->Frame->TurnedToDevice(felt.Normal);
  felt.Velocity = this->OffsetVelocity.Update(felt.Offset, step.Passed);
  const Vector3 force = ContactForce(this->Structure->Law, felt);
  this->Factor = this->Weight.Advance(step.Passed);
  this->NormalDevice = felt.Normal;
  this->Force = this->Factor * (force + this->TextureForce(felt, force, proxyWorld) +
                                VolumeViscosity(this->Structure->Viscosity, felt,
                                                this->ToolRadiusDevice, step.HandVelocity));
  if (this->Feed != nullptr)
  {
    this->Force += this->Drill(step, felt, this->Factor * force.dot(felt.Normal));
  }
  return this->Force;
}

// Feeds the tool towards the probe, and what is felt of that beside the contact.
Vector3 StructureFollower::Drill(const FollowStep& step, const ContactOffset& felt,
                                 double push) noexcept
{
  const DrillLaw& law = this->Structure->Drill;
  const DrillMotion& motion = this->Tool->Motion;
  if (!this->IsCut(step) || !felt.IsTouching)
  {
    felt.IsTouching ? this->Feed->Rest() : this->Feed->Leave();
    return Vector3::Zero();
  }
  const double pushed = std::clamp(push, 0.0, step.MostPush);
  const double passed = std::clamp(step.Passed, 0.0, LongestFeed);
  const double went = this->Feed->Advance(FeedRate(law, motion, pushed) * passed);
  return DrillForce(law, motion, pushed, felt.Normal, step.HandVelocity,
                    passed > 0.0 ? went / passed : 0.0, step.Time);
}

// By the image where the tool touches, as a sphere does.
Vector3 StructureFollower::TextureForce(const ContactOffset& felt, const Vector3& contactForce,
                                        const Vector3& proxyWorld) const noexcept
{
  if (this->Structure->Texture == nullptr || !felt.IsTouching)
  {
    return Vector3::Zero();
  }
  const Vector3 outWorld = this->Frame->TurnedToWorld(felt.Normal);
  const double push = contactForce.dot(felt.Normal);
  return this->Structure->Texture->Force(push, proxyWorld - this->ToolRadiusWorld * outWorld) *
         felt.Normal;
}
} // namespace palpate
