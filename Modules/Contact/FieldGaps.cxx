#include "FieldGaps.h"

#include "RigidProxy.h"
#include "ToolSkeleton.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostCandidates = 64;
constexpr std::size_t MostFeet = 12;
} // namespace

// Half a voxel is known around any surface; a stride may not leap over the reach.
FieldGaps::FieldGaps(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool,
                     const SurfaceFriction& friction)
    : Solid(std::move(solid)), Friction(friction), Radius(tool.Skeleton()->Balls().front().Radius),
      Extent(tool.BoundingRadius()),
      Reach(std::max(0.5 * Solid->VoxelSize(), 1.2 * RigidProxy::Stride))
{
  for (std::size_t n = 0; n < tool.Points().size(); ++n)
  {
    const Vector3 outward = -tool.Normals()[n];
    this->Points.push_back({tool.Points()[n] - this->Radius * outward, outward});
  }
  this->Places.resize(this->Points.size());
  this->Inside.resize(this->Points.size());
  this->Candidates.resize(MostCandidates);
}

// Every second, third, … of the points that are near, if there are many: feet slide from them.
void FieldGaps::FindCandidates() noexcept
{
  const auto near = static_cast<std::size_t>(
      std::count_if(this->Inside.begin(), this->Inside.end(), [](auto in) { return in != 0; }));
  const std::size_t every = 1 + near / MostCandidates;
  std::size_t met = 0;
  this->CandidateCount = 0;
  for (std::size_t n = 0; n < this->Points.size(); ++n)
  {
    if (this->Inside[n] == 0 || met++ % every != 0)
    {
      continue;
    }
    const Vector3 inward = this->Turned * -this->Points[n].Outward;
    const FieldSolid::Wall wall =
        this->Solid->WallNear(this->Places[n] + this->Reach * inward, inward);
    if (wall.IsKnown)
    {
      this->Candidates[this->CandidateCount++] = {wall.Distance, n};
    }
  }
  std::sort(this->Candidates.begin(), this->Candidates.begin() + this->CandidateCount,
            [](const Candidate& a, const Candidate& b)
            { return a.Gap < b.Gap || (a.Gap == b.Gap && a.Number < b.Number); });
}

// From the candidates that were chosen before, by half a radius.
bool FieldGaps::IsApart(std::size_t number, std::size_t chosen) const noexcept
{
  const auto placeOf = [this](std::size_t n)
  { return Vector3(this->Points[n].Axis + this->Radius * this->Points[n].Outward); };
  return std::none_of(
      this->Candidates.begin(), this->Candidates.begin() + chosen,
      [&](const Candidate& other)
      { return (placeOf(other.Number) - placeOf(number)).norm() < 0.5 * this->Radius; });
}

double FieldGaps::DistanceToBounds(const ToolPose& pose) const noexcept
{
  return this->Solid->BoundsWorld().exteriorDistance(pose.PositionWorld) - this->Extent;
}

void FieldGaps::PlaceAll(const ToolPose& pose, double lifted) noexcept
{
  this->Turned = pose.Orientation.toRotationMatrix();
  for (std::size_t n = 0; n < this->Points.size(); ++n)
  {
    const Point& point = this->Points[n];
    this->Places[n] =
        pose.PositionWorld + this->Turned * (point.Axis + (this->Radius + lifted) * point.Outward);
  }
  this->Solid->AreInside(this->Places.data(), this->Places.size(), this->Inside.data());
}

void FieldGaps::AddFoot(const ToolPose& pose, std::size_t number,
                        PoseConstraints& limits) const noexcept
{
  constexpr int Slides = 3;
  const Vector3 axis = pose.Orientation * this->Points[number].Axis;
  Vector3 inward = -(pose.Orientation * this->Points[number].Outward);
  PoseConstraint foot;
  FieldSolid::Wall wall;
  for (int slide = 0; slide < Slides; ++slide)
  {
    foot.Arm = axis - this->Radius * inward;
    wall = this->Solid->WallNear(pose.PositionWorld + foot.Arm, inward);
    if (!wall.IsKnown || wall.Distance > RigidProxy::Margin)
    {
      return;
    }
    inward = wall.Normal;
  }
  const bool isKnown = std::any_of(limits.begin(), limits.end(),
                                   [&](const PoseConstraint& other)
                                   { return (other.Arm - foot.Arm).norm() < 0.1 * this->Radius; });
  if (!isKnown)
  {
    foot.Normal = wall.Normal;
    foot.Gap = wall.Distance;
    foot.Friction = this->Friction;
    foot.Source = number;
    limits.Add(foot);
  }
}

double FieldGaps::Gather(const ToolPose& pose, PoseConstraints& limits) noexcept
{
  const double away = this->DistanceToBounds(pose);
  if (away > RigidProxy::Margin)
  {
    return away;
  }
  this->PlaceAll(pose, this->Reach);
  this->FindCandidates();
  std::size_t chosen = 0;
  for (std::size_t n = 0; n < this->CandidateCount && chosen < MostFeet; ++n)
  {
    const Candidate candidate = this->Candidates[n];
    if (this->IsApart(candidate.Number, chosen))
    {
      this->Candidates[chosen++] = candidate;
      this->AddFoot(pose, candidate.Number, limits);
    }
  }
  return 0.0; // what is beyond the reach is unknown
}

bool FieldGaps::IsFreeAt(const ToolPose& pose) noexcept
{
  if (this->DistanceToBounds(pose) > 0.0)
  {
    return true;
  }
  this->PlaceAll(pose, -std::min(std::max(Slack, 0.25 * this->Solid->VoxelSize()), this->Radius));
  return std::none_of(this->Inside.begin(), this->Inside.end(),
                      [](unsigned char inside) { return inside != 0; });
}
} // namespace palpate
