#pragma once

#include "FadingContact.h"
#include "HandoverLimit.h"
#include "ReachIndex.h"
#include "StructureFollower.h"
#include "TouchScene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace palpate
{
/// How a scene replaces the previous one. Neither raises the force of a resting hand: see
/// Servo::Publish.
enum class SceneEntry
{
  FadeIn,    ///< begins without contact
  Continuing ///< structures with the same id carry on
};

/// A scene with all data that the servo thread needs. Created and destroyed by the publishing
/// thread, used by the servo thread.
///
/// A tick examines only structures near the tool: those that an index finds in a box larger than
/// the tool's path, and no others while the path stays within it. The result has the same bits as
/// if all structures were examined in order.
class ServoScene
{
public:
  /// Result of a tick, in the device's frame.
  struct Feeling
  {
    Vector3 Force = Vector3::Zero(); ///< N, the sum over all structures
    Vector3 Field = Vector3::Zero(); ///< N, of their force fields, in addition
    /// N mm about the tool's origin, the sum; of tools of several balls.
    Vector3 Torque = Vector3::Zero();
    /// Of the tool's proxy, in the world: the hand's, but for tools of several balls.
    Eigen::Quaterniond ProxyOrientation = Eigen::Quaterniond::Identity();
    int Structure = -1;    ///< the one touched most deeply; -1 without contact
    Contact Deepest;       ///< of that structure
    bool IsValid = true;   ///< every model gave a valid result
    bool IsBuried = false; ///< a structure contains the tool, which did not move there
    bool IsBehind = false; ///< a proxy has not reached its place (Contact::IsBehind)
  };

  /// `turnLength` (mm of the hand; 0: no torque is shown): the device's, which limits how much a
  /// turn counts as a shift, or the stiffness of turns would exceed what is stable.
  static Status Make(std::shared_ptr<const TouchScene> scene, double velocityTimeConstant,
                     std::unique_ptr<ServoScene>& made, double turnLength = 0.0);

  Feeling Follow(const FollowStep& step) noexcept;
  /// Call before the first Follow, which must be placed: structures near the tool in the previous
  /// scene carry on here if a structure has the same id, and other contacts fade out. Force and
  /// torque of all contacts then rise by the hand's motion only (HandoverLimit).
  void CarryOn(const ServoScene& before) noexcept;
  /// The structure here with the id of one in another scene; -1 if none.
  int IndexOf(const ServoScene& other, int structure) const noexcept;
  /// Of the versions in use.
  std::uint64_t VersionNumber() const noexcept { return this->Version; }
  /// Passes on the cuts of this tick, numbered from `number`, which is then advanced.
  void OrderCuts(std::uint64_t& number) noexcept;
  /// Nothing is cut before the next contact.
  void LiftDrill() noexcept;
  /// Forgets the tool's position.
  void Leave() noexcept;
  /// Number of structures that the last Follow examined.
  std::size_t LookedAtCount() const noexcept { return this->NearCount; }
  /// Of followers, their trackers and the index, without the models.
  std::size_t Bytes() const noexcept;
  const TouchScene& Scene() const noexcept { return *this->Shared; }
  SceneEntry Entry() const noexcept { return this->EnteredAs; }
  void SetEntry(SceneEntry entry) noexcept { this->EnteredAs = entry; }

private:
  static constexpr std::size_t MostContacts = 8; // more than a tool usually touches
  struct FadingStructure
  {
    int Structure = -1; // that replaces it; -1 for none
    FadingContact Contact;
  };

  void CarryOn(const StructureFollower& before, std::uint32_t next) noexcept;
  void LookAround(const FollowStep& step) noexcept;
  void MoveTool(const FollowStep& step) noexcept;
  void TakeVersions() noexcept;
  void BeginAgain(const FollowStep& step) noexcept;
  void FadeOut(int structure, const FadingContact& contact) noexcept;
  int Find(int id) const noexcept;
  double StiffnessDevice() const noexcept;
  void FollowNear(const FollowStep& step, Feeling& feeling, Vector3& field) noexcept;
  void HandOver(const FollowStep& step, Feeling& feeling) noexcept;
  explicit ServoScene(std::shared_ptr<const TouchScene> scene) : Shared(std::move(scene)) {}

  std::shared_ptr<const TouchScene> Shared;
  std::shared_ptr<SharedProxy> Tool; // of several balls; null for others
  struct ToolPlace
  {
    ToolPose Proxy;
    ToolPose Hand;
    DeviceFrame Frame;
  };
  std::optional<ToolPlace> ToolBefore; // in the previous scene
  ToolPose ToolHand;                   // of the last Follow
  std::vector<StructureFollower> Followers;
  ReachIndex Index;
  Eigen::AlignedBox3d LookedAt; // world; from inside it, no structure outside Near can be touched
  double Margin = 0.0;          // mm, around the path for which LookedAt was computed
  std::vector<std::uint32_t> Near; // followers, ascending; capacity for all
  std::size_t NearCount = 0;
  std::vector<std::pair<int, int>> Ids; // ids and their structures; ascending
  std::array<FadingStructure, MostContacts> Fading;
  std::array<FollowedBefore, MostContacts> Carried; // of the previous scene
  HandoverLimit Limit;                              // of all contacts
  ToolWrench ContactNow;                            // of the last Follow
  Vector3 TorqueBefore = Vector3::Zero();           // N mm, of the previous scene, which fades out
  Vector3 FieldNow = Vector3::Zero();               // N, likewise
  Vector3 FieldBefore = Vector3::Zero();            // N, likewise
  RampIn Handover{0.0};                             // of this scene, after another one
  Vector3 Hand = Vector3::Zero();                   // mm, device's frame, of the last Follow
  Eigen::Quaterniond HandTurn = Eigen::Quaterniond::Identity(); // likewise
  std::vector<std::uint32_t> Drilled;                           // followers
  const DrillVersions* Versions = nullptr;                      // in use; owned by the link
  std::uint64_t Version = 0;                                    // their number
  bool HasGrown = false; // since the last Follow that queried models
  SceneEntry EnteredAs = SceneEntry::FadeIn;
};
} // namespace palpate
