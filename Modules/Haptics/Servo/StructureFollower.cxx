#include "StructureFollower.h"

#include "ElasticForce.h"
#include "SharedTracker.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// mm; a tool is never this far from its proxy, except after a failed computation.
constexpr double LargestDepth = 1e4;

// Whether a contact is valid for a force; every comparison fails for NaN.
bool IsSound(const Contact& contact, const Vector3& probeWorld) noexcept
{
  if (!contact.IsValid)
  {
    return false;
  }
  if (contact.Elastic != nullptr && !contact.Elastic->ForceWorld.allFinite())
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

// s; limit of the time for which one tick feeds a drill.
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
                                     std::unique_ptr<ContactTracker> tracker)
    : Tracker(std::move(tracker)), Structure(&structure), Frame(&scene.Frame), Tool(&scene.Drill),
      Reach(ReachWorld(structure, scene.Tool)), ToolRadiusWorld(LeastRadius(scene.Tool)),
      ToolRadiusDevice(scene.Frame.LengthDevice(ToolRadiusWorld * Vector3::UnitX()).norm()),
      OffsetVelocity(velocityTimeConstant), Law(structure.Law)
{
  if (structure.Site >= 0)
  {
    this->Feed = std::make_unique<DrillFeed>(scene.Drill.Motion.Radius, scene.Drill.Clearance);
  }
}

Eigen::AlignedBox3d StructureFollower::ReachWorld(const TouchStructure& structure,
                                                  const ToolShape& tool)
{
  Eigen::AlignedBox3d reach = structure.Model->BoundsWorld();
  reach.min().array() -= tool.BoundingRadius();
  reach.max().array() += tool.BoundingRadius();
  for (const auto& effect : structure.Effects)
  {
    if (effect->Field() != nullptr)
    {
      reach.extend(effect->Field()->BoundsWorld());
    }
  }
  return reach;
}

Status StructureFollower::Make(const TouchStructure& structure, const TouchScene& scene,
                               double velocityTimeConstant,
                               std::vector<StructureFollower>& followers,
                               const std::shared_ptr<SharedProxy>& shared)
{
  std::unique_ptr<ContactTracker> tracker;
  std::unique_ptr<ToolGaps> gaps;
  const Status status = shared != nullptr
                            ? structure.Model->MakeGaps(scene.Tool, structure.Friction, gaps)
                            : structure.Model->MakeTracker(scene.Tool, structure.Friction, tracker);
  if (!status.IsOk())
  {
    return Status::Failure("The structure " + structure.Name +
                           " cannot be touched: " + status.Message());
  }
  const SharedTracker* member = nullptr;
  if (shared != nullptr)
  {
    auto made = std::make_unique<SharedTracker>(shared, shared->Add(std::move(gaps)));
    member = made.get();
    tracker = std::move(made);
  }
  if (structure.Site >= 0 && !tracker->CanBeDrilled())
  {
    return Status::Failure("The structure " + structure.Name +
                           " cannot be drilled: it needs a field model with a proxy.");
  }
  followers.push_back(
      StructureFollower(structure, scene, velocityTimeConstant, std::move(tracker)));
  followers.back().Shared = member;
  return Status::Success();
}

std::size_t StructureFollower::Bytes() const noexcept
{
  return sizeof(*this) + this->Tracker->Bytes() + (this->Feed != nullptr ? sizeof(DrillFeed) : 0);
}

bool StructureFollower::IsInReach(const FollowStep& step) const noexcept
{
  return this->HoldsTool() || step.PathWorld().intersects(this->Reach);
}

void StructureFollower::Leave() noexcept
{
  this->Follows = false;
  this->IsBuried = false;
  this->Before = nullptr;
  this->Weight = RampIn(0.0);
  this->Force.setZero();
  this->TorqueDevice.setZero();
  this->OfFields.setZero();
  this->OffsetVelocity.Reset();
  this->Interpolation.Reset();
  if (this->Feed != nullptr)
  {
    this->Feed->Leave();
  }
}

FollowedBefore StructureFollower::Ending() const noexcept
{
  FollowedBefore ending{this->Last, this->LastProbe, *this->Frame, this->ToolRadiusWorld};
  ending.Last.Elastic = nullptr; // of a tracker that goes
  return ending;
}

void StructureFollower::CarryOn(const StructureFollower& before,
                                const FollowedBefore* state) noexcept
{
  this->Before = state;
  if (this->Feed != nullptr && before.Feed != nullptr)
  {
    *this->Feed = *before.Feed;
  }
}

void StructureFollower::BeginAt(const ToolPose& pose) noexcept
{
  this->OffsetVelocity.Reset();
  this->Tracker->Release();
  this->Tracker->Follow(pose);
}

void StructureFollower::UseSolid(const FieldSolid& solid, std::uint64_t version) noexcept
{
  this->Tracker->UseSolid(solid);
  this->Feed->Arrive(version);
}

bool StructureFollower::BeginAgain(const FollowStep& step) noexcept
{
  if (this->Follows)
  {
    this->Feed->Leave();
    const double out = this->Last.IsTouching ? this->Tracker->SurfaceTolerance() : 0.0;
    const ToolPose place{this->Last.ProxyWorld + out * this->Last.NormalWorld,
                         step.Now.Orientation};
    this->Tracker->Release();
    this->IsBuried = !this->Tracker->IsFreeAt(place);
    if (!this->IsBuried)
    {
      this->BeginAt(place);
    }
    this->Weight = RampIn(this->Last.IsTouching ? HandoverDuration : 0.0);
  }
  return this->Follows;
}

void StructureFollower::Unbury(const FollowStep& step) noexcept
{
  this->IsBuried = !this->Tracker->IsFreeAt(step.Now);
  if (!this->IsBuried)
  {
    this->BeginAt(step.Now);
  }
  this->Interpolation.Reset();
}

bool StructureFollower::NextCut(CutOrder& order) noexcept
{
  order.Site = this->Structure->Site;
  order.Tool = this->Tool->Tool;
  return this->Feed->NextCut(order);
}

FadingContact StructureFollower::FadingOut(const Vector3& hand) const noexcept
{
  return {this->Force, this->NormalDevice, this->Factor * this->StiffnessDevice(), hand};
}

// Of the last contact, at the hand.
double StructureFollower::StiffnessDevice() const noexcept
{
  return this->Last.Elastic != nullptr ? this->Last.Elastic->Slope * this->Frame->Magnification()
                                       : this->Law.Stiffness;
}

// Between results of the model, the force changes with the depth by its slope.
Vector3 StructureFollower::ElasticPush(const Vector3& offsetWorld) const noexcept
{
  const Vector3& normal = this->Last.NormalWorld;
  const Vector3& force = this->Last.Elastic->ForceWorld;
  const double deeper = (offsetWorld - (this->Last.ProxyWorld - this->LastProbe)).dot(normal);
  return force + std::max(this->Last.Elastic->Slope * deeper, -force.dot(normal)) * normal;
}

// Where a contact of the previous scene goes on: the lowest place above its proxy at which the tool
// is free. None for a tool that a new frame has moved.
bool StructureFollower::FindStart(const FollowStep& step, ToolPose& start) noexcept
{
  if (this->Before == nullptr)
  {
    return false;
  }
  const FollowedBefore& before = *this->Before;
  const double scale = this->Frame->Magnification();
  const double jump = (step.Now.PositionWorld - before.ProbeWorld).norm();
  if (before.Frame != *this->Frame && jump > LongestJump * scale)
  {
    return false;
  }
  const double grown = std::max(0.0, this->ToolRadiusWorld - before.ToolRadius);
  const double least = this->Tracker->SurfaceTolerance() + grown;
  this->Tracker->Release();
  for (const double lifted : {0.0, 0.125, 0.25, 0.5, 1.0})
  {
    const double height = least + lifted * MostLifted * scale;
    start = {before.Last.ProxyWorld + height * before.Last.NormalWorld, step.Now.Orientation};
    if (this->Tracker->IsFreeAt(start))
    {
      return true;
    }
  }
  return false;
}

// A tool that came by the hand's motion starts at the place before this tick, which was out of
// reach: so a path around a structure is never taken for one through it. A tool that was placed
// inside is not pushed out.
void StructureFollower::Enter(const FollowStep& step) noexcept
{
  ToolPose from = step.IsPlaced ? step.Now : step.Last;
  const bool isContinued = step.IsPlaced && this->FindStart(step, from);
  this->Before = nullptr;
  this->Weight = RampIn(isContinued ? HandoverDuration : 0.0);
  this->Tracker->Release();
  this->IsBuried = step.IsPlaced && !isContinued && !this->Tracker->IsFreeAt(from);
  if (isContinued || !step.IsPlaced) // else the tracker starts where the tool is followed next
  {
    this->BeginAt(from);
  }
  if (!isContinued)
  {
    this->OffsetVelocity.Update(Vector3::Zero(), step.Passed);
  }
  this->Follows = true;
}

void StructureFollower::AskModel(const FollowStep& step) noexcept
{
  this->Last = this->Tracker->Follow(step.Now);
  this->LastProbe = step.Now.PositionWorld;
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
  felt.IsElastic = this->Last.Elastic != nullptr;
  if (felt.IsElastic && felt.IsTouching)
  {
    felt.Push = this->ElasticPush(felt.Offset);
    felt.Slope = this->StiffnessDevice();
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
    return this->BeSilent(step);
  }
  ContactOffset felt = this->Felt(step);
  if (step.AsksModel && this->EntersByCut())
  {
    this->IsBuried = true;
    return this->BeSilent(step);
  }
  if (this->Feed != nullptr && felt.IsTouching)
  {
    felt.Offset = this->Fed(step, felt.Offset);
  }
  const Vector3 proxyWorld = step.Now.PositionWorld + felt.Offset;
  felt.Offset = this->Frame->LengthDevice(felt.Offset);
  felt.Normal = this->Frame->TurnedToDevice(felt.Normal);
  felt.Push = this->Frame->TurnedToDevice(felt.Push);
  felt.Velocity = this->OffsetVelocity.Update(felt.Offset, step.Passed);
  EffectTouch touch = this->TouchOf(felt, proxyWorld, step);
  if (felt.IsTouching)
  {
    this->Law.Stiffness = this->StiffnessAt(touch);
  }
  touch.ContactForce = ContactForce(this->Law, felt);
  this->Factor = this->Weight.Advance(step.Passed);
  this->NormalDevice = felt.Normal;
  this->Force = this->Factor * this->WithEffects(touch);
  this->TorqueDevice = this->Factor * this->TorqueOf(this->Last);
  this->OfFields = this->FieldForceAt(step.Now.PositionWorld);
  if (this->Feed != nullptr)
  {
    this->Force += this->Drill(
        step, felt, this->Factor * this->CutPart() * touch.ContactForce.dot(felt.Normal));
  }
  return this->Force;
}

// Arms and shifts are shorter at the hand where the world is magnified.
Vector3 StructureFollower::TorqueOf(const Contact& contact) const noexcept
{
  const double scale = this->Frame->Magnification();
  return contact.IsTouching ? Vector3(this->Law.Stiffness / (scale * scale) *
                                      this->Frame->TurnedToDevice(contact.Turn))
                            : Vector3::Zero();
}

Vector3 StructureFollower::BeSilent(const FollowStep& step) noexcept
{
  this->Last = Untouched(step.Now.PositionWorld);
  this->Force.setZero();
  this->TorqueDevice.setZero();
  this->OfFields = this->Follows ? this->FieldForceAt(step.Now.PositionWorld) : Vector3::Zero();
  return Vector3::Zero();
}

// Once inside, a side wall would push out as well; so nothing is felt until the tool has left.
bool StructureFollower::EntersByCut() const noexcept
{
  const Vector3& normal = this->Last.NormalWorld;
  return this->Last.IsTouching &&
         IsOnCut(this->Structure->Cuts, this->SurfaceNear(this->Last.ProxyWorld, normal), normal);
}

// From the probe to the tool, mm, ahead of the proxy. A tool of several balls is where its proxy
// is, and goes on by what holds up its cutting part.
Vector3 StructureFollower::Fed(const FollowStep& step, const Vector3& offset) noexcept
{
  if (this->Shared == nullptr)
  {
    return this->Feed->Meet(step.Now, offset, this->IsCut(step));
  }
  const Vector3& cut = this->Shared->CutOffset();
  ToolPose goal = this->Shared->ProxyPose();
  goal.PositionWorld -= cut;
  return offset - cut + this->Feed->Meet(goal, cut, this->IsCut(step));
}

// Of the push, by what cuts of the tool.
double StructureFollower::CutPart() const noexcept
{
  return this->Shared != nullptr && this->Last.Depth > 0.0
             ? std::min(this->Shared->CutOffset().norm() / this->Last.Depth, 1.0)
             : 1.0;
}

// Feeds the tool towards the probe; returns the drilling force in addition to the contact's.
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

// Where the tool touches: a sphere with its side, one of several balls at its foot.
Vector3 StructureFollower::SurfaceNear(const Vector3& proxyWorld,
                                       const Vector3& normalWorld) const noexcept
{
  return this->Last.HasFoot ? this->Last.FootWorld
                            : Vector3(proxyWorld - this->ToolRadiusWorld * normalWorld);
}

EffectTouch StructureFollower::TouchOf(const ContactOffset& felt, const Vector3& proxyWorld,
                                       const FollowStep& step) const noexcept
{
  EffectTouch touch;
  touch.Contact = felt;
  touch.HandVelocity = step.HandVelocity;
  touch.CenterDepth = this->ToolRadiusDevice;
  touch.OwnStiffness = this->Structure->Law.Stiffness;
  touch.SurfaceWorld = this->SurfaceNear(proxyWorld, this->Frame->TurnedToWorld(felt.Normal));
  touch.WorldPerDevice = this->Frame->WorldPerDevice();
  touch.Time = step.Time;
  return touch;
}

Vector3 StructureFollower::FieldForceAt(const Vector3& originWorld) const noexcept
{
  Vector3 forceWorld = Vector3::Zero();
  for (const auto& effect : this->Structure->Effects)
  {
    if (const ForceField* const field = effect->Field())
    {
      forceWorld += field->ForceWorld(originWorld);
    }
  }
  return this->Frame->TurnedToDevice(forceWorld);
}

double StructureFollower::StiffnessAt(const EffectTouch& touch) const noexcept
{
  double stiffness = touch.OwnStiffness;
  for (const auto& effect : this->Structure->Effects)
  {
    stiffness = effect->StiffnessAt(stiffness, touch.SurfaceWorld);
  }
  return stiffness;
}

Vector3 StructureFollower::WithEffects(const EffectTouch& touch) const noexcept
{
  Vector3 force = touch.ContactForce + Vector3::Zero(); // -0 becomes 0, as recordings have it
  for (const auto& effect : this->Structure->Effects)
  {
    force += effect->Force(touch);
  }
  return force;
}
} // namespace palpate
