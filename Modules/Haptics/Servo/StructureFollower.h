#pragma once

#include "ContactForce.h"
#include "ContactTracker.h"
#include "DrillFeed.h"
#include "FadingContact.h"
#include "ForceInterpolation.h"
#include "RampIn.h"
#include "SharedProxy.h"
#include "TouchScene.h"
#include "VelocityEstimate.h"

#include <memory>

namespace palpate
{
class SharedTracker;

/// Input of a follower's tick.
struct FollowStep
{
  ToolPose Last;                          ///< at the last tick of the model
  ToolPose Now;                           ///< at this tick
  double Passed = 0.0;                    ///< s since the last tick
  Vector3 Hand = Vector3::Zero();         ///< mm, device's frame
  Vector3 HandVelocity = Vector3::Zero(); ///< mm/s, device's frame
  bool AsksModel = true;                  ///< otherwise the last result is interpolated
  double ModelPeriod = 0.0; ///< s between ticks of the model; 0 if every tick queries it
  /// The tool did not move to Now by the hand: first step of a scene, or after forces were off. A
  /// structure that contains the tool is then buried.
  bool IsPlaced = false;
  bool IsDrilling = false;
  double Time = 0.0;     ///< s, of the tick; phase of vibrations
  double MostPush = 0.0; ///< N, the device's limit: a larger push does not drive a drill faster

  /// Contains the path from Last to Now.
  Eigen::AlignedBox3d PathWorld() const noexcept
  {
    return {this->Last.PositionWorld.cwiseMin(this->Now.PositionWorld),
            this->Last.PositionWorld.cwiseMax(this->Now.PositionWorld)};
  }
};

/// State of a structure's follower in a scene that another one replaces.
struct FollowedBefore
{
  Contact Last;
  Vector3 ProbeWorld = Vector3::Zero(); ///< at which it was computed, mm
  DeviceFrame Frame;
  double ToolRadius = 0.0; ///< mm
};

/// One structure on the servo thread: queries its tracker only if the tool could reach it, and
/// converts its contact to a force. Does not allocate after construction.
class StructureFollower
{
public:
  StructureFollower(StructureFollower&&) = default;
  StructureFollower& operator=(StructureFollower&&) = delete;
  StructureFollower(const StructureFollower&) = delete;
  StructureFollower& operator=(const StructureFollower&) = delete;
  ~StructureFollower() = default;

  /// Creates the tracker, for a tool of several balls one of `shared`, which is null for others.
  /// Keeps the addresses of both; the structure must belong to the scene. `velocityTimeConstant` in
  /// s.
  static Status Make(const TouchStructure& structure, const TouchScene& scene,
                     double velocityTimeConstant, std::vector<StructureFollower>& followers,
                     const std::shared_ptr<SharedProxy>& shared = nullptr);

  /// The force (N) in the device's frame.
  Vector3 Follow(const FollowStep& step) noexcept;

  /// N mm, device's frame: about the tool's origin, of the last Follow.
  const Vector3& Torque() const noexcept { return this->TorqueDevice; }
  /// N, device's frame: of the structure's force fields, in addition to the result of the last
  /// Follow.
  const Vector3& FieldForce() const noexcept { return this->OfFields; }

  /// Box in which the tool's origin may touch or be in a force field, mm.
  static Eigen::AlignedBox3d ReachWorld(const TouchStructure& structure, const ToolShape& tool);
  /// Whether Follow would query the tracker now. Otherwise no call is needed, once one has
  /// registered that the tool left. In contact, wherever the hand is: the proxy is at the
  /// structure.
  bool IsInReach(const FollowStep& step) const noexcept;
  /// Whether the structure holds the proxy of the last Follow.
  bool HoldsTool() const noexcept
  {
    return this->Before != nullptr || (this->Follows && this->Last.IsTouching);
  }
  /// Its proxy, within the structure's reach despite rounding, mm.
  Vector3 HeldWorld() const noexcept
  {
    const Contact& held = this->Before != nullptr ? this->Before->Last : this->Last;
    return held.ProxyWorld.cwiseMax(this->Reach.min()).cwiseMin(this->Reach.max());
  }

  /// Forgets the tool's position: the next Follow starts from scratch.
  void Leave() noexcept;

  /// For the scene that replaces this one.
  FollowedBefore Ending() const noexcept;
  /// Carries on from this structure's follower in the previous scene. `state` is its Ending if it
  /// held the tool, else null, and is used by the next Follow, which must be placed. That starts at
  /// the old proxy, or up to MostLifted above it, if the tool is free there now and has not jumped,
  /// so that nothing is passed through from there to the probe. Otherwise a structure that contains
  /// the probe is buried: no force until the tool has left it.
  void CarryOn(const StructureFollower& before, const FollowedBefore* state) noexcept;
  /// mm of the hand; of a shape that grew.
  static constexpr double MostLifted = 2.0;
  /// mm of the hand, with a new frame; a contact does not carry on over more.
  static constexpr double LongestJump = 1.0;
  /// Uses this version of a drilled field from now on. The solid must live until the next one is
  /// set.
  void UseSolid(const FieldSolid& solid, std::uint64_t version) noexcept;
  /// Material may have been added. If the tool is inside, there is no force until the tool has
  /// left: material that grows back never pushes the hand out. Returns whether there was a contact.
  bool BeginAgain(const FollowStep& step) noexcept;
  /// The next cut into the structure. Returns false if there is none in this tick.
  bool NextCut(CutOrder& order) noexcept;
  void CutOrdered(const CutOrder& order) noexcept { this->Feed->Ordered(order); }
  void LiftDrill() noexcept { this->Feed->Rest(); }
  /// Its field in the scene; -1 for none.
  int Site() const noexcept { return this->Structure->Site; }
  /// The last contact, with the hand at `hand` (mm, device's frame), to be faded out.
  FadingContact FadingOut(const Vector3& hand) const noexcept;
  /// N/mm of the hand, of the last contact.
  double StiffnessDevice() const noexcept;
  bool IsFollowing() const noexcept { return this->Follows; }
  /// Whether it contains the tool, which did not move there through its surface, and is silent.
  bool IsSilent() const noexcept { return this->IsBuried; }
  int Id() const noexcept { return this->Structure->Id; }

  /// With its tracker.
  std::size_t Bytes() const noexcept;

  /// Of the last Follow. Invalid if the model gave no valid result.
  const Contact& Touched() const noexcept { return this->Last; }

private:
  StructureFollower(const TouchStructure& structure, const TouchScene& scene,
                    double velocityTimeConstant, std::unique_ptr<ContactTracker> tracker);

  void Enter(const FollowStep& step) noexcept;
  void AskModel(const FollowStep& step) noexcept;
  void BeginAt(const ToolPose& pose) noexcept;
  void Unbury(const FollowStep& step) noexcept;
  bool IsCut(const FollowStep& step) const noexcept
  {
    return step.IsDrilling && this->Structure->Drill.Wear > 0.0;
  }
  bool EntersByCut() const noexcept;
  Vector3 SurfaceNear(const Vector3& proxyWorld, const Vector3& normalWorld) const noexcept;
  Vector3 TorqueOf(const Contact& contact) const noexcept;
  Vector3 BeSilent(const FollowStep& step) noexcept;
  Vector3 Fed(const FollowStep& step, const Vector3& offset) noexcept;
  double CutPart() const noexcept;
  Vector3 Drill(const FollowStep& step, const ContactOffset& felt, double push) noexcept;
  bool FindStart(const FollowStep& step, ToolPose& start) noexcept;
  ContactOffset Felt(const FollowStep& step) noexcept;
  Vector3 ElasticPush(const Vector3& offsetWorld) const noexcept;
  EffectTouch TouchOf(const ContactOffset& felt, const Vector3& proxyWorld,
                      const FollowStep& step) const noexcept;
  Vector3 FieldForceAt(const Vector3& originWorld) const noexcept;
  double StiffnessAt(const EffectTouch& touch) const noexcept;
  Vector3 WithEffects(const EffectTouch& touch) const noexcept;

  std::unique_ptr<ContactTracker> Tracker;
  const SharedTracker* Shared = nullptr; // the tracker, of a tool of several balls
  std::unique_ptr<DrillFeed> Feed;       // null: not drilled
  const TouchStructure* Structure;
  const DeviceFrame* Frame;
  const TouchDrill* Tool;
  Eigen::AlignedBox3d Reach;
  double ToolRadiusWorld;  // mm, smallest distance from the tool's centre to its surface
  double ToolRadiusDevice; // the same in mm of the hand
  VelocityEstimate OffsetVelocity;
  ForceInterpolation Interpolation;
  Contact Last;
  Vector3 LastProbe = Vector3::Zero(); // at which it was computed, mm
  bool Follows = false;
  bool IsBuried = false; // around a tool that did not enter it by moving, or by a cut
  const FollowedBefore* Before = nullptr; // from which it carries on
  RampIn Weight{0.0};                     // fade-in of its force
  double Factor = 1.0;                    // of the weight, last value
  ContactLaw Law;                         // of the last contact, with its effects
  Vector3 Force = Vector3::Zero();
  Vector3 TorqueDevice = Vector3::Zero();
  Vector3 OfFields = Vector3::Zero();
  Vector3 NormalDevice = Vector3::UnitZ(); // of it
};
} // namespace palpate
