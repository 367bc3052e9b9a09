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
  const std::vector<TouchStructure>& structures = next->Shared->Structures;
  std::vector<Eigen::AlignedBox3d> reaches;
  next->Followers.reserve(structures.size());
  for (const TouchStructure& structure : structures)
  {
    if (!status.IsOk())
    {
      return status;
    }
    status =
        StructureFollower::Make(structure, *next->Shared, velocityTimeConstant, next->Followers);
    reaches.push_back(StructureFollower::ReachWorld(structure, next->Shared->Tool));
  }
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
      sizeof(*this) + this->Index.Bytes() + this->Near.size() * sizeof(this->Near[0]);
  for (const StructureFollower& follower : this->Followers)
  {
    bytes += follower.Bytes();
  }
  return bytes;
}

void ServoScene::Leave() noexcept
{
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    this->Followers[this->Near[i]].Leave();
  }
}

void ServoScene::LookAround(const FollowStep& step) noexcept
{
  constexpr double Wider = 8.0;   // ways, on each side
  constexpr double TooWide = 4.0; // times that, for a hand that has become slower
  constexpr std::size_t Few = 8;
  const Eigen::AlignedBox3d way = step.WayWorld();
  const double margin = Wider * way.sizes().maxCoeff();
  const bool isTooWide = this->NearCount > Few && this->Margin > TooWide * margin;
  if (this->LookedAt.contains(way) && !isTooWide)
  {
    return;
  }
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    StructureFollower& follower = this->Followers[this->Near[i]];
    if (!follower.IsInReach(step))
    {
      follower.Leave();
    }
  }
  this->Margin = margin;
  this->LookedAt = {way.min().array() - margin, way.max().array() + margin};
  this->NearCount = this->Index.Find(this->LookedAt, this->Near.data());
}

ServoScene::Feeling ServoScene::Follow(const FollowStep& step) noexcept
{
  Feeling feeling;
  feeling.Deepest.ProxyWorld = step.Now.PositionWorld;
  if (step.AsksModel)
  {
    this->LookAround(step);
  }
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    StructureFollower& follower = this->Followers[this->Near[i]];
    feeling.Force += follower.Follow(step);
    const Contact& contact = follower.Touched();
    feeling.IsValid = feeling.IsValid && contact.IsValid;
    if (contact.IsTouching && (feeling.Structure < 0 || contact.Depth > feeling.Deepest.Depth))
    {
      feeling.Structure = static_cast<int>(this->Near[i]);
      feeling.Deepest = contact;
    }
  }
  return feeling;
}
} // namespace palpate
