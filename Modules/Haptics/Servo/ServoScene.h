#pragma once

#include "ReachIndex.h"
#include "StructureFollower.h"
#include "TouchScene.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
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
  /// Forgets where the tool was.
  void Leave() noexcept;
  /// How many structures the last Follow looked at.
  std::size_t LookedAtCount() const noexcept { return this->NearCount; }
  /// Of followers, their trackers and the index, without the models.
  std::size_t Bytes() const noexcept;
  const TouchScene& Scene() const noexcept { return *this->Shared; }

private:
  void LookAround(const FollowStep& step) noexcept;
  explicit ServoScene(std::shared_ptr<const TouchScene> scene) : Shared(std::move(scene)) {}

  std::shared_ptr<const TouchScene> Shared;
  std::vector<StructureFollower> Followers;
  ReachIndex Index;
  Eigen::AlignedBox3d LookedAt;    // world; outside of Near nothing can be touched from in here
  double Margin = 0.0;             // mm, of it round the way that it was made for
  std::vector<std::uint32_t> Near; // followers, ascending; has room for all
  std::size_t NearCount = 0;
};
} // namespace palpate
