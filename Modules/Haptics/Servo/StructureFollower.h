#pragma once

#include "ContactForce.h"
#include "ContactTracker.h"
#include "DrillFeed.h"
#include "FadingContact.h"
#include "ForceInterpolation.h"
#include "RampIn.h"
#include "TouchScene.h"
#include "VelocityEstimate.h"

#include <memory>
#include <optional>

namespace palpate
{
/// How a tick's follower is to go on from the last one.
struct FollowStep
{
  ToolPose Last;                          ///< at the last tick of the model
  ToolPose Now;                           ///< at this tick
  double Passed = 0.0;                    ///< s since the last tick
  Vector3 Hand = Vector3::Zero();         ///< mm, device's frame
  Vector3 HandVelocity = Vector3::Zero(); ///< mm/s, device's frame
  bool AsksModel = true;                  ///< else what was felt is interpolated
  double ModelPeriod = 0.0; ///< s between ticks of the model; 0 where every tick asks it
  /// s. In the first step of a scene that continues another one what the tool comes upon may have
  /// grown round it: that is felt more and more for so long. 0 in all other steps.
  double FadeIn = 0.0;
  bool IsDrilling = false;
  double Time = 0.0;     ///< s, of the tick; vibrations go by it
  double MostPush = 0.0; ///< N, that the device gives: no more drives a drill

  /// Holds the way from Last to Now.
  Eigen::AlignedBox3d WayWorld() const noexcept
  {
    return {this->Last.PositionWorld.cwiseMin(this->Now.PositionWorld),
            this->Last.PositionWorld.cwiseMax(this->Now.PositionWorld)};
  }
};

/// One structure on the servo thread: asks its tracker only where the tool could reach it, and
/// turns its contact into a force. Allocates nothing after it was made.
class StructureFollower
{
public:
  StructureFollower(StructureFollower&&) = default;
  StructureFollower& operator=(StructureFollower&&) = delete;
  StructureFollower(const StructureFollower&) = delete;
  StructureFollower& operator=(const StructureFollower&) = delete;
  ~StructureFollower() = default;

  /// Makes the tracker. Keeps the addresses of both; the structure is one of the scene's.
  /// `velocityTimeConstant` in s.
  static Status Make(const TouchStructure& structure, const TouchScene& scene,
                     double velocityTimeConstant, std::vector<StructureFollower>& followers);

  /// The force (N) in the device's frame.
  Vector3 Follow(const FollowStep& step) noexcept;

  /// Where the tool's origin may touch, mm.
  static Eigen::AlignedBox3d ReachWorld(const TouchStructure& structure, const ToolShape& tool);
  /// Whether Follow would ask the tracker now. Where it would not it needs no call, once a call has
  /// noticed that the tool left.
  bool IsInReach(const FollowStep& step) const noexcept;

  /// Forgets where the tool was: the next Follow begins anew.
  void Leave() noexcept;

  /// Goes on from what followed this structure in the scene before: the next Follow, with a FadeIn,
  /// begins free of touch at that one's proxy, so that nothing is passed through from there to the
  /// probe. Where the proxy is inside now, it begins as a tool that is put inside.
  void CarryOn(const StructureFollower& before) noexcept;
  /// Feels that version of the field which it is drilled in from now on. The solid has to live
  /// until the next one is given.
  void UseSolid(const FieldSolid& solid, std::uint64_t version) noexcept;
  /// There may be more of it now. Where the tool is inside, nothing is felt of it until the tool
  /// has left: nobody is shoved out of what grew back round the hand. Whether anything was felt.
  bool BeginAgain(const FollowStep& step) noexcept;
  /// The next cut into it. False where there is none in this tick.
  bool NextCut(CutOrder& order) noexcept;
  void CutOrdered(const CutOrder& order) noexcept { this->Feed->Ordered(order); }
  void LiftDrill() noexcept { this->Feed->Rest(); }
  /// The field of the scene's that it is felt by; -1 for none.
  int Site() const noexcept { return this->Structure->Site; }
  /// What was felt last, with the hand at `hand` (mm, device's frame), to be faded out.
  FadingContact FadingOut(const Vector3& hand) const noexcept;
  bool IsFollowing() const noexcept { return this->Follows; }
  int Id() const noexcept { return this->Structure->Id; }

  /// With its tracker.
  std::size_t Bytes() const noexcept;

  /// Of the last Follow. Invalid where the model gave nothing that can be felt.
  const Contact& Touched() const noexcept { return this->Last; }

private:
  StructureFollower(const TouchStructure& structure, const TouchScene& scene,
                    double velocityTimeConstant, std::unique_ptr<ContactTracker> tracker);

  void Enter(const FollowStep& step) noexcept;
  void AskModel(const FollowStep& step) noexcept;
  const Contact& BeginAt(const Vector3& placeWorld, const FollowStep& step) noexcept;
  void Unbury(const FollowStep& step) noexcept;
  bool IsCut(const FollowStep& step) const noexcept
  {
    return step.IsDrilling && this->Structure->Drill.Wear > 0.0;
  }
  Vector3 Drill(const FollowStep& step, const ContactOffset& felt, double push) noexcept;
  ContactOffset Felt(const FollowStep& step) noexcept;
  Vector3 WithEffects(const Vector3& contactForce, const ContactOffset& felt,
                      const Vector3& proxyWorld, const FollowStep& step) const noexcept;

  std::unique_ptr<ContactTracker> Tracker;
  std::unique_ptr<DrillFeed> Feed; // none: it is not drilled
  const TouchStructure* Structure;
  const DeviceFrame* Frame;
  const TouchDrill* Tool;
  Eigen::AlignedBox3d Reach;
  double ToolRadiusWorld;  // mm, from the tool's centre to its surface where that is nearest
  double ToolRadiusDevice; // the same in mm of the hand
  VelocityEstimate OffsetVelocity;
  ForceInterpolation Interpolation;
  Contact Last;
  bool Follows = false;
  bool IsBuried = false;         // in what grew back round the tool
  std::optional<Contact> Before; // that it carries on from
  RampIn Weight{0.0};            // of its force
  double Factor = 1.0;           // by the weight, of the last one
  Vector3 Force = Vector3::Zero();
  Vector3 NormalDevice = Vector3::UnitZ(); // of it
};
} // namespace palpate
