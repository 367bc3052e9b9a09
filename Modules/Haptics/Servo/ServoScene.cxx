#include "ServoScene.h"

#include <utility>

namespace palpate
{
Status ServoScene::Make(std::shared_ptr<const TouchScene> scene, double velocityTimeConstant,
                        std::unique_ptr<ServoScene>& made)
{
  if (scene == nullptr)
  {
    return Status::Failure("There is no scene to be felt.");
  }
  Status status = scene->Check();
  // Its constructor is private to std::make_unique too.
  std::unique_ptr<ServoScene> next(new ServoScene(std::move(scene)));
  next->Followers.reserve(next->Shared->Structures.size());
  for (const TouchStructure& structure : next->Shared->Structures)
  {
    if (status.IsOk())
    {
      status =
          StructureFollower::Make(structure, *next->Shared, velocityTimeConstant, next->Followers);
    }
  }
  if (status.IsOk())
  {
    made = std::move(next);
  }
  return status;
}

void ServoScene::Leave() noexcept
{
  for (StructureFollower& follower : this->Followers)
  {
    follower.Leave();
  }
}

ServoScene::Feeling ServoScene::Follow(const FollowStep& step) noexcept
{
  Feeling feeling;
  feeling.Deepest.ProxyWorld = step.Now.PositionWorld;
  for (std::size_t i = 0; i < this->Followers.size(); ++i)
  {
    feeling.Force += this->Followers[i].Follow(step);
    const Contact& contact = this->Followers[i].Touched();
    feeling.IsValid = feeling.IsValid && contact.IsValid;
    if (contact.IsTouching && (feeling.Structure < 0 || contact.Depth > feeling.Deepest.Depth))
    {
      feeling.Structure = static_cast<int>(i);
      feeling.Deepest = contact;
    }
  }
  return feeling;
}
} // namespace palpate
