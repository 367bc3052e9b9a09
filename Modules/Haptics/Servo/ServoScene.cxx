#include "ServoScene.h"

#include <algorithm>
#include <utility>

namespace palpate
{
Status ServoScene::Make(std::shared_ptr<const TouchScene> scene, double velocityTimeConstant,
                        std::unique_ptr<ServoScene>& made, double turnLength)
{
  if (scene == nullptr)
  {
    return Status::Failure("There is no scene to publish.");
  }
  Status status = scene->Check();
  // std::make_unique cannot call the private constructor.
  std::unique_ptr<ServoScene> next(new ServoScene(std::move(scene)));
  const std::vector<TouchStructure>& structures = next->Shared->Structures;
  std::vector<Eigen::AlignedBox3d> reaches;
  next->Followers.reserve(structures.size());
  if (const ToolSkeleton* const skeleton = next->Shared->SharedTool())
  {
    const double longest = turnLength * next->Shared->Frame.Magnification();
    next->Tool = std::make_shared<SharedProxy>(
        *skeleton,
        turnLength > 0.0 ? std::min(longest, skeleton->Gyration()) : skeleton->Gyration());
  }
  for (const TouchStructure& structure : structures)
  {
    if (!status.IsOk())
    {
      return status;
    }
    status = StructureFollower::Make(structure, *next->Shared, velocityTimeConstant,
                                     next->Followers, next->Tool);
    reaches.push_back(StructureFollower::ReachWorld(structure, next->Shared->Tool));
    if (structure.Id != 0)
    {
      next->Ids.emplace_back(structure.Id, static_cast<int>(reaches.size()) - 1);
    }
    if (structure.Site >= 0)
    {
      next->Drilled.push_back(static_cast<std::uint32_t>(reaches.size() - 1));
    }
  }
  std::sort(next->Ids.begin(), next->Ids.end());
  next->Index = ReachIndex(reaches);
  next->Near.resize(structures.size());
  if (status.IsOk())
  {
    made = std::move(next);
  }
  return status;
}

std::size_t ServoScene::Bytes() const noexcept
{
  std::size_t bytes =
      sizeof(*this) + this->Index.Bytes() + this->Near.size() * sizeof(this->Near[0]) +
      this->Ids.size() * sizeof(this->Ids[0]) + this->Drilled.size() * sizeof(this->Drilled[0]);
  for (const StructureFollower& follower : this->Followers)
  {
    bytes += follower.Bytes();
  }
  bytes += this->Tool != nullptr ? this->Tool->Bytes() : 0;
  return bytes;
}

void ServoScene::Leave() noexcept
{
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    this->Followers[this->Near[i]].Leave();
  }
  this->Fading = {};
  this->ToolBefore.reset();
  this->Limit = HandoverLimit();
  this->ContactNow = {};
  this->TorqueBefore.setZero();
  this->FieldNow.setZero();
  this->FieldBefore.setZero();
}

int ServoScene::Find(int id) const noexcept
{
  const auto found = std::lower_bound(this->Ids.begin(), this->Ids.end(), std::make_pair(id, 0));
  return found != this->Ids.end() && found->first == id ? found->second : -1;
}

int ServoScene::IndexOf(const ServoScene& other, int structure) const noexcept
{
  return structure < 0 ? -1 : this->Find(other.Followers[static_cast<std::size_t>(structure)].Id());
}

// One for each structure; if all are in use, the one with the smallest force is replaced.
void ServoScene::FadeOut(int structure, const FadingContact& contact) noexcept
{
  const auto same = std::find_if(this->Fading.begin(), this->Fading.end(),
                                 [&](const FadingStructure& one)
                                 { return structure >= 0 && one.Structure == structure; });
  if (same != this->Fading.end())
  {
    same->Contact = FadingContact::Joined(same->Contact, contact);
    return;
  }
  const auto least = std::min_element(
      this->Fading.begin(), this->Fading.end(),
      [](const FadingStructure& one, const FadingStructure& other)
      { return one.Contact.Force().squaredNorm() < other.Contact.Force().squaredNorm(); });
  if (contact.Force().squaredNorm() > least->Contact.Force().squaredNorm())
  {
    *least = {structure, contact};
  }
}

void ServoScene::CarryOn(const ServoScene& before) noexcept
{
  this->Limit = HandoverLimit(before.ContactNow, before.Hand, before.HandTurn);
  this->TorqueBefore = before.ContactNow.Torque;
  this->FieldBefore = before.FieldNow;
  if (this->Tool != nullptr && before.Tool != nullptr)
  {
    this->ToolBefore = {before.Tool->Pose(), before.ToolHand, before.Shared->Frame};
  }
  this->Handover = RampIn(HandoverDuration);
  for (const FadingStructure& one : before.Fading)
  {
    this->FadeOut(this->IndexOf(before, one.Structure), one.Contact);
  }
  for (std::size_t i = 0; i < before.NearCount; ++i)
  {
    const StructureFollower& last = before.Followers[before.Near[i]];
    if (!last.IsFollowing())
    {
      continue;
    }
    const int next = this->Find(last.Id());
    this->FadeOut(next, last.FadingOut(before.Hand));
    if (next >= 0)
    {
      this->CarryOn(last, static_cast<std::uint32_t>(next));
    }
  }
}

// Of a structure that holds the tool the state is kept until the next Follow, which looks around.
void ServoScene::CarryOn(const StructureFollower& before, std::uint32_t next) noexcept
{
  const FollowedBefore* state = nullptr;
  if (before.HoldsTool() && this->NearCount < MostContacts)
  {
    this->Carried[this->NearCount] = before.Ending();
    state = &this->Carried[this->NearCount];
    this->Near[this->NearCount++] = next;
  }
  this->Followers[next].CarryOn(before, state);
}

void ServoScene::LookAround(const FollowStep& step) noexcept
{
  constexpr double Wider = 8.0;   // paths, on each side
  constexpr double TooWide = 4.0; // times that, if the hand has become slower
  constexpr std::size_t Few = 8;
  Eigen::AlignedBox3d path = step.PathWorld();
  const double margin = Wider * path.sizes().maxCoeff();
  if (this->Tool != nullptr && !step.IsPlaced)
  {
    path.extend(this->Tool->Pose().PositionWorld); // where it may meet others than the hand
  }
  const bool isTooWide = this->NearCount > Few && this->Margin > TooWide * margin;
  if (this->LookedAt.contains(path) && !isTooWide)
  {
    return;
  }
  this->Margin = margin;
  this->LookedAt = {path.min().array() - margin, path.max().array() + margin};
  // A structure that holds the tool stays near wherever the hand is.
  Eigen::AlignedBox3d searched = this->LookedAt;
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    StructureFollower& follower = this->Followers[this->Near[i]];
    if (follower.HoldsTool())
    {
      searched.extend(follower.HeldWorld());
    }
    else if (!follower.IsInReach(step))
    {
      follower.Leave();
    }
  }
  this->NearCount = this->Index.Find(searched, this->Near.data());
}

// One that was placed begins there, or where the previous scene held it, unless a new frame has
// moved the hand away.
void ServoScene::MoveTool(const FollowStep& step) noexcept
{
  if (step.IsPlaced)
  {
    const bool isContinued =
        this->ToolBefore &&
        (this->ToolBefore->Frame == this->Shared->Frame ||
         (step.Now.PositionWorld - this->ToolBefore->Hand.PositionWorld).norm() <=
             StructureFollower::LongestJump * this->Shared->Frame.Magnification());
    this->Tool->Begin(isContinued ? this->ToolBefore->Proxy : step.Now, this->Near.data(),
                      this->NearCount);
    this->ToolBefore.reset();
  }
  this->Tool->Follow(step.Now, this->Near.data(), this->NearCount);
  this->ToolHand = step.Now;
}

// Takes versions that are newer, or that this scene has not used yet.
void ServoScene::TakeVersions() noexcept
{
  DrillLink* const link = this->Shared->Drill.Link.get();
  if (link == nullptr || (!link->Versions.Refresh() && this->Versions != nullptr))
  {
    return;
  }
  const DrillVersions* const newest = link->Versions.Current();
  if (newest == nullptr)
  {
    return;
  }
  for (const std::uint32_t drilled : this->Drilled)
  {
    StructureFollower& follower = this->Followers[drilled];
    const auto site = static_cast<std::size_t>(follower.Site());
    if (site < newest->Solids.size())
    {
      follower.UseSolid(*newest->Solids[site], newest->Number);
    }
  }
  this->HasGrown = this->HasGrown || (this->Versions != nullptr && newest->GrownAt > this->Version);
  this->Versions = newest;
  this->Version = newest->Number;
}

void ServoScene::BeginAgain(const FollowStep& step) noexcept
{
  if (!this->HasGrown)
  {
    return;
  }
  this->HasGrown = false;
  for (const std::uint32_t drilled : this->Drilled)
  {
    StructureFollower& follower = this->Followers[drilled];
    if (this->Tool != nullptr)
    {
      this->Tool->AskAgain(drilled);
    }
    const FadingContact last = follower.FadingOut(this->Hand);
    if (follower.BeginAgain(step))
    {
      this->FadeOut(static_cast<int>(drilled), last);
    }
  }
}

void ServoScene::OrderCuts(std::uint64_t& number) noexcept
{
  for (const std::uint32_t drilled : this->Drilled)
  {
    StructureFollower& follower = this->Followers[drilled];
    CutOrder order;
    order.Number = number;
    if (follower.NextCut(order) && this->Shared->Drill.Link->Orders.Push(order))
    {
      follower.CutOrdered(order);
      ++number;
    }
  }
}

void ServoScene::LiftDrill() noexcept
{
  for (const std::uint32_t drilled : this->Drilled)
  {
    this->Followers[drilled].LiftDrill();
  }
}

// The largest of the contacts.
double ServoScene::StiffnessDevice() const noexcept
{
  double largest = 0.0;
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    const StructureFollower& follower = this->Followers[this->Near[i]];
    largest = std::max(largest, follower.HoldsTool() ? follower.StiffnessDevice() : 0.0);
  }
  return largest;
}

// Adds the structures in reach.
void ServoScene::FollowNear(const FollowStep& step, Feeling& feeling, Vector3& field) noexcept
{
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    StructureFollower& follower = this->Followers[this->Near[i]];
    feeling.Force += follower.Follow(step);
    feeling.Torque += follower.Torque();
    field += follower.FieldForce();
    const Contact& contact = follower.Touched();
    feeling.IsValid = feeling.IsValid && contact.IsValid;
    feeling.IsBuried = feeling.IsBuried || follower.IsSilent();
    feeling.IsBehind = feeling.IsBehind || contact.IsBehind;
    if (contact.IsTouching && (feeling.Structure < 0 || contact.Depth > feeling.Deepest.Depth))
    {
      feeling.Structure = static_cast<int>(this->Near[i]);
      feeling.Deepest = contact;
    }
  }
}

// Adds what fades out of the previous scene, and limits the sum.
void ServoScene::HandOver(const FollowStep& step, Feeling& feeling) noexcept
{
  for (FadingStructure& one : this->Fading)
  {
    if (!one.Contact.IsOver())
    {
      feeling.Force += one.Contact.Advance(step.Hand, step.Passed);
    }
  }
  const DeviceFrame& frame = this->Shared->Frame;
  this->Hand = step.Hand;
  this->HandTurn = frame.OrientationDevice(step.Now.Orientation);
  if (!this->Limit.IsOver())
  {
    const double gyration =
        this->Tool != nullptr ? this->Tool->Gyration() / frame.Magnification() : 0.0;
    const ToolWrench limited =
        this->Limit.Limited({feeling.Force, feeling.Torque}, this->StiffnessDevice(), gyration,
                            this->Hand, this->HandTurn, step.Passed);
    feeling.Force = limited.Force;
    feeling.Torque = limited.Torque;
  }
  this->ContactNow = {feeling.Force, feeling.Torque};
}

ServoScene::Feeling ServoScene::Follow(const FollowStep& step) noexcept
{
  Feeling feeling;
  feeling.Deepest.ProxyWorld = step.Now.PositionWorld;
  feeling.ProxyOrientation = step.Now.Orientation;
  if (step.AsksModel)
  {
    this->TakeVersions();
    this->LookAround(step);
    this->BeginAgain(step);
    if (this->Tool != nullptr)
    {
      this->MoveTool(step);
    }
  }
  const double newPart = this->Handover.Advance(step.Passed);
  Vector3 field = Vector3::Zero();
  this->FollowNear(step, feeling, field);
  feeling.Torque += (1.0 - newPart) * this->TorqueBefore;
  this->HandOver(step, feeling);
  if (this->Tool != nullptr)
  {
    feeling.Deepest.ProxyWorld = this->Tool->Pose().PositionWorld;
    feeling.ProxyOrientation = this->Tool->Pose().Orientation;
  }
  for (const auto& everywhere : this->Shared->Fields)
  {
    const Vector3 force = everywhere->ForceWorld(step.Now.PositionWorld);
    field += this->Shared->Frame.TurnedToDevice(force);
  }
  feeling.Field = newPart * field + (1.0 - newPart) * this->FieldBefore;
  this->FieldNow = feeling.Field;
  return feeling;
}
} // namespace palpate
