#include "TouchRay.h"

#include "FieldSolid.h"
#include "SoleTracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// How a hand that does not turn holds the tool.
Eigen::Quaterniond TurnOf(const TouchScene& scene)
{
  return scene.Frame.PoseWorld(DeviceSample()).Orientation;
}

Status MakeTracker(const ContactModel& model, const TouchScene& scene,
                   std::unique_ptr<ContactTracker>& tracker)
{
  const ToolSkeleton* const skeleton = scene.SharedTool();
  if (skeleton == nullptr)
  {
    return model.MakeTracker(scene.Tool, SurfaceFriction(), tracker);
  }
  std::unique_ptr<ToolGaps> gaps;
  const Status status = model.MakeGaps(scene.Tool, SurfaceFriction(), gaps);
  if (status.IsOk())
  {
    tracker = std::make_unique<SoleTracker>(*skeleton, std::move(gaps));
  }
  return status;
}
} // namespace

// The part of the line on which a structure may be met.
struct TouchRay::Way
{
  Vector3 From;
  Vector3 Direction; // unit
  double Begin = 0.0;
  double End = 0.0; // mm from From
  Eigen::Quaterniond Turn = Eigen::Quaterniond::Identity();

  ToolPose At(double along) const { return {this->From + along * this->Direction, this->Turn}; }
  // Keeps what lies in a box; false if nothing does.
  bool Clip(const Eigen::AlignedBox3d& box)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (this->Direction[a] == 0.0)
      {
        if (this->From[a] < box.min()[a] || this->From[a] > box.max()[a])
        {
          return false;
        }
        continue;
      }
      double near = (box.min()[a] - this->From[a]) / this->Direction[a];
      double far = (box.max()[a] - this->From[a]) / this->Direction[a];
      if (near > far)
      {
        std::swap(near, far);
      }
      this->Begin = std::max(this->Begin, near);
      this->End = std::min(this->End, far);
    }
    return this->Begin <= this->End;
  }
};

void TouchRay::UseSolids(std::vector<std::shared_ptr<const FieldSolid>> solids)
{
  this->Solids = std::move(solids);
}

ContactTracker* TouchRay::TrackerOf(std::size_t structure)
{
  this->Trackers.resize(this->Scene->Structures.size());
  this->CannotBeTouched.resize(this->Scene->Structures.size());
  std::unique_ptr<ContactTracker>& tracker = this->Trackers[structure];
  const TouchStructure& touched = this->Scene->Structures[structure];
  if (tracker == nullptr && !this->CannotBeTouched[structure])
  {
    this->CannotBeTouched[structure] = !MakeTracker(*touched.Model, *this->Scene, tracker).IsOk();
  }
  const auto site = static_cast<std::size_t>(touched.Site);
  // A version that no solid could be made of leaves the one before.
  if (tracker != nullptr && touched.Site >= 0 && site < this->Solids.size() &&
      this->Solids[site] != nullptr)
  {
    tracker->UseSolid(*this->Solids[site]);
  }
  return tracker.get();
}

std::optional<TouchRay::Rest> TouchRay::FirstOn(std::size_t structure, const Way& way)
{
  constexpr double Steps = 256.0; // along the largest extent of the structure's box
  constexpr int Halvings = 12;
  ContactTracker* tracker = this->TrackerOf(structure);
  if (tracker == nullptr)
  {
    return std::nullopt;
  }
  const double extent = this->Scene->Structures[structure].Model->BoundsWorld().sizes().maxCoeff();
  const double step = std::max(this->Scene->Tool.BoundingRadius(), extent / Steps);
  const auto follow = [&](double along) { return tracker->Follow(way.At(along)); };
  tracker->Release();
  double free = way.Begin;
  if (!tracker->IsFreeAt(way.At(free)))
  {
    return std::nullopt; // the line begins inside
  }
  follow(free);
  while (free < way.End)
  {
    const double next = std::min(free + step, way.End);
    Contact met = follow(next);
    if (!met.IsTouching)
    {
      free = next;
      continue;
    }
    double held = next;
    for (int halving = 0; halving < Halvings; ++halving)
    {
      follow(free);
      const double middle = 0.5 * (free + held);
      const Contact tried = follow(middle);
      (tried.IsTouching ? held : free) = middle;
      met = tried.IsTouching ? tried : met;
    }
    return Rest{way.At(free).PositionWorld, met.NormalWorld, static_cast<int>(structure)};
  }
  return std::nullopt;
}

bool TouchRay::IsFree(const Vector3& toolWorld)
{
  const ToolPose pose{toolWorld, TurnOf(*this->Scene)};
  for (std::size_t s = 0; s < this->Scene->Structures.size(); ++s)
  {
    const Eigen::AlignedBox3d bounds = this->Scene->Structures[s].Model->BoundsWorld();
    const bool isNear = bounds.exteriorDistance(toolWorld) <= this->Scene->Tool.BoundingRadius();
    ContactTracker* tracker = isNear ? this->TrackerOf(s) : nullptr;
    if (tracker == nullptr)
    {
      continue;
    }
    tracker->Release();
    if (!tracker->IsFreeAt(pose))
    {
      return false;
    }
  }
  return true;
}

std::optional<TouchRay::Rest> TouchRay::First(const Vector3& from, const Vector3& to)
{
  const double length = (to - from).norm();
  if (!std::isfinite(length) || length == 0.0)
  {
    return std::nullopt;
  }
  Way whole{from, (to - from) / length, 0.0, length, TurnOf(*this->Scene)};
  std::optional<Rest> first;
  for (std::size_t s = 0; s < this->Scene->Structures.size(); ++s)
  {
    const Eigen::AlignedBox3d bounds = this->Scene->Structures[s].Model->BoundsWorld();
    // A little more than the tool's size, so that the way begins outside.
    const double margin = 1.01 * this->Scene->Tool.BoundingRadius() + 0.01;
    Way way = whole;
    if (!way.Clip({bounds.min().array() - margin, bounds.max().array() + margin}))
    {
      continue;
    }
    if (const std::optional<Rest> rest = this->FirstOn(s, way))
    {
      first = rest;
      whole.End = (rest->ToolWorld - from).norm(); // others count only if they are nearer
    }
  }
  return first;
}
} // namespace palpate
