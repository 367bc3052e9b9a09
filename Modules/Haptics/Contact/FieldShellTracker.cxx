#include "FieldShellTracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
FieldShellTracker::FieldShellTracker(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool)
    : Solid(std::move(solid)), Shell(tool), Reach(tool.BoundingRadius()),
      MostTouching(static_cast<int>(Shell.Count() / 2))
{
}

const Contact& FieldShellTracker::Follow(const ToolPose& pose) noexcept
{
  const Vector3 normal = this->Felt.NormalWorld;
  this->Felt = Contact();
  if (!pose.IsUsable())
  {
    return this->Felt;
  }
  const Vector3& probe = pose.PositionWorld;
  this->Felt.IsValid = true;
  this->Felt.Material = this->Solid->Material();
  this->Shell.Turn(pose.Orientation);
  const bool isFar = this->Solid->BoundsWorld().exteriorDistance(probe) > this->Reach;
  const int touching = isFar ? 0 : this->Shell.CountInside(*this->Solid, probe);
  this->ProxyWorld = touching > this->MostTouching && this->HasProxy ? this->PathBack(probe)
                     : touching > 0                                  ? this->PushedOut(probe)
                                                                     : probe;
  this->HasProxy = true;
  const Vector3 path = this->ProxyWorld - probe;
  this->Felt.IsTouching = touching > 0;
  this->Felt.ProxyWorld = this->ProxyWorld;
  this->Felt.Depth = path.norm();
  this->Felt.NormalWorld = this->Felt.Depth > 0.0 ? Vector3(path / this->Felt.Depth) : normal;
  return this->Felt;
}

// By the points last found inside.
Vector3 FieldShellTracker::PushedOut(const Vector3& probe) const noexcept
{
  Vector3 sum = Vector3::Zero();
  double lengths = 0.0;
  int touching = 0;
  for (std::size_t i = 0; i < this->Shell.Count(); ++i)
  {
    if (this->Shell.IsInside(i))
    {
      const Vector3& inward = this->Shell.InwardNormal(i);
      const double length =
          this->Solid->DistanceToExit(probe + this->Shell.Offset(i), inward, this->Reach);
      sum += length * inward;
      lengths += length;
      ++touching;
    }
  }
  const double size = sum.norm();
  // Vectors that cancel up to rounding have no direction.
  return size > 1e-12 * lengths ? Vector3(probe + (lengths / touching / size) * sum) : probe;
}

// In quarters of a voxel; if those would be too many, in longer steps and then by bisection.
Vector3 FieldShellTracker::PathBack(const Vector3& probe) noexcept
{
  constexpr double StepsPerVoxel = 4.0;
  constexpr double MostSteps = 64.0;
  const Vector3 path = this->ProxyWorld - probe;
  const double wanted = std::ceil(StepsPerVoxel * path.norm() / this->Solid->VoxelSize());
  const double steps = std::clamp(wanted, 1.0, MostSteps);
  double free = 1.0;
  for (int step = 1; step < static_cast<int>(steps) && free == 1.0; ++step)
  {
    free = this->IsOutsideAt(probe + step / steps * path) ? step / steps : 1.0;
  }
  double touching = free - 1.0 / steps;
  double length = wanted / steps; // in quarters of a voxel
  while (length > 1.0)
  {
    const double middle = 0.5 * (touching + free);
    (this->IsOutsideAt(probe + middle * path) ? free : touching) = middle;
    length *= 0.5;
  }
  return probe + free * path;
}

bool FieldShellTracker::IsOutsideAt(const Vector3& place) noexcept
{
  return this->Shell.CountInside(*this->Solid, place) <= this->MostTouching;
}
} // namespace palpate
