#pragma once

#include "FadingContact.h"
#include "ReachIndex.h"
#include "StructureFollower.h"
#include "TouchScene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
/// How a scene takes the place of the one before.
enum class SceneEntry
{
  Anew,      ///< whatever it is, it fades in from nothing
  Continuing ///< what has the same id goes on from where it was felt
};

/// A scene with all that the servo thread needs to feel it. Made by the publishing thread, used by
/// the servo thread, destroyed by the publishing thread.
///
/// A tick looks at what is near the tool: those structures that an index finds in a box that is
/// larger than the tool's way, and for as long as the way stays within it no others. What is felt
/// has the same bits as if all had been asked, in their order.
class ServoScene
{
public:
  /// What a tick felt, in the device's frame.
  struct Feeling
  {
    Vector3 Force = Vector3::Zero(); ///< N, the sum over all structures
    int Structure = -1;              ///< touched most deeply; -1 without touch
    Contact Deepest;                 ///< of that structure
    bool IsValid = true;             ///< every model gave something that can be felt
  };

  static Status Make(std::shared_ptr<const TouchScene> scene, double velocityTimeConstant,
                     std::unique_ptr<ServoScene>& made);

  Feeling Follow(const FollowStep& step) noexcept;
  /// Before the first Follow, which gets a FadeIn: what the tool is near to in the scene before
  /// goes on here, where a structure has the same id, and what was felt there fades out.
  void CarryOn(const ServoScene& before) noexcept;
  /// The structure here that has the id of one in another scene, -1 for none.
  int IndexOf(const ServoScene& other, int structure) const noexcept;
  /// Of the versions that are felt.
  std::uint64_t VersionNumber() const noexcept { return this->Version; }
  /// Hands out the cuts of this tick, numbered from `number` on, which then is the next one's.
  void OrderCuts(std::uint64_t& number) noexcept;
  /// Nothing is cut before the tool touches again.
  void LiftDrill() noexcept;
  /// Forgets where the tool was.
  void Leave() noexcept;
  /// How many structures the last Follow looked at.
  std::size_t LookedAtCount() const noexcept { return this->NearCount; }
  /// Of followers, their trackers and the index, without the models.
  std::size_t Bytes() const noexcept;
  const TouchScene& Scene() const noexcept { return *this->Shared; }
  SceneEntry Entry() const noexcept { return this->EnteredAs; }
  void SetEntry(SceneEntry entry) noexcept { this->EnteredAs = entry; }

private:
  struct FadingStructure
  {
    int Structure = -1; // that takes its place; -1 for none
    FadingContact Contact;
  };

  void LookAround(const FollowStep& step) noexcept;
  void TakeVersions() noexcept;
  void BeginAgain(const FollowStep& step) noexcept;
  void FadeOut(int structure, const FadingContact& contact) noexcept;
  int Find(int id) const noexcept;
  explicit ServoScene(std::shared_ptr<const TouchScene> scene) : Shared(std::move(scene)) {}

  std::shared_ptr<const TouchScene> Shared;
  std::vector<StructureFollower> Followers;
  ReachIndex Index;
  Eigen::AlignedBox3d LookedAt;    // world; outside of Near nothing can be touched from in here
  double Margin = 0.0;             // mm, of it round the way that it was made for
  std::vector<std::uint32_t> Near; // followers, ascending; has room for all
  std::size_t NearCount = 0;
  std::vector<std::pair<int, int>> Ids;    // of structures that have one, and which; ascending
  std::array<FadingStructure, 8> Fading;   // more at once than a tool touches
  Vector3 Hand = Vector3::Zero();          // mm, device's frame, of the last Follow
  std::vector<std::uint32_t> Drilled;      // followers
  const DrillVersions* Versions = nullptr; // that are felt; the link's
  std::uint64_t Version = 0;               // their number
  bool HasGrown = false;                   // since the last Follow that asked models
  SceneEntry EnteredAs = SceneEntry::Anew;
};
} // namespace palpate
