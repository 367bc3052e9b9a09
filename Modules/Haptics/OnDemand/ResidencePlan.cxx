#include "ResidencePlan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
ResidencePlan::ResidencePlan(const FieldGrid& grid,
                             const std::shared_ptr<const FieldSurvey>& survey,
                             const ResidenceSettings& settings)
    : Grid(grid), Survey(survey), Settings(settings),
      Ahead(settings.PromisedSpeed, settings.LeastDelay)
{
}

BrickBox ResidencePlan::BoxRound(const ToolPlace& place, double way) const
{
  const BrickLayout& layout = this->Survey->Layout();
  const Vector3 probe = this->Grid.PointIndex(place.ProbeWorld);
  const Vector3 proxy = this->Grid.PointIndex(place.ProxyWorld);
  // Two voxels more, since what a ray begins in is looked up just before it.
  constexpr double Rim = 2.0;
  const Vector3 reach =
      Vector3::Constant(this->Settings.AskedReach + way).cwiseQuotient(this->Grid.Spacing()) +
      Vector3::Constant(Rim);
  BrickBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const auto brickOf = [&layout, a](double index)
    {
      const double brick = std::floor(index / layout.Cells);
      return static_cast<int>(std::clamp(brick, 0.0, layout.Bricks[a] - 1.0));
    };
    box.First[a] = brickOf(std::min(probe[axis], proxy[axis]) - reach[axis]);
    box.Last[a] = brickOf(std::max(probe[axis], proxy[axis]) + reach[axis]);
  }
  return box;
}

std::optional<BrickBox> ResidencePlan::Look(const ToolPlace& place)
{
  if (!place.IsFinite())
  {
    return std::nullopt;
  }
  this->Ahead.Look(place);
  const double way = this->Ahead.Length();
  const bool isFaster = way > 1.5 * this->WishedWay && std::isfinite(this->Kept);
  if (this->Middle && this->Middle->WayTo(place) <= 0.5 * this->Way && !isFaster)
  {
    return std::nullopt;
  }
  this->Middle = place;
  this->WishedWay = way;
  if (this->Survey->RecordCount() <= this->Settings.Room)
  {
    this->Way = this->Kept = std::numeric_limits<double>::infinity();
    const auto& bricks = this->Survey->Layout().Bricks;
    return BrickBox{{0, 0, 0}, {bricks[0] - 1, bricks[1] - 1, bricks[2] - 1}};
  }
  constexpr double Shorter = 0.8;
  constexpr int MostTrials = 16;
  this->Way = way;
  BrickBox box = this->BoxRound(place, this->Way);
  for (int trial = 0; trial<MostTrials&& this->Survey->RecordCount(box)> this->Settings.Room;
       ++trial)
  {
    this->Way *= Shorter;
    box = this->BoxRound(place, this->Way);
  }
  this->Kept = 0.5 * this->Way / this->Ahead.Delay();
  return box;
}
} // namespace palpate
