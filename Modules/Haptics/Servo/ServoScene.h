#pragma once

#include "StructureFollower.h"
#include "TouchScene.h"

#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
/// A scene with all that the servo thread needs to feel it. Made by the publishing thread, used by
/// the servo thread, destroyed by the publishing thread.
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
  const TouchScene& Scene() const noexcept { return *this->Shared; }

private:
  explicit ServoScene(std::shared_ptr<const TouchScene> scene) : Shared(std::move(scene)) {}

  std::shared_ptr<const TouchScene> Shared;
  std::vector<StructureFollower> Followers;
};
} // namespace palpate
