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

// Half a voxel is known around any surface; a stride may not leap over the reach. Feet are half a
// radius apart, or a voxel on small balls.
FieldGaps::FieldGaps(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool,
                     const SurfaceFriction& friction)
    : ToolGaps(*tool.Skeleton(), friction), Solid(std::move(solid)), Extent(tool.BoundingRadius()),
      Apart(Solid->VoxelSize()), Reach(std::max(0.5 * Solid->VoxelSize(), 1.2 * RigidProxy::Stride))
{
  for (std::size_t n = 0; n < tool.Points().size(); ++n)
  {
    this->Points.push_back({tool.BallAt(n), -tool.Normals()[n]});
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

// From the candidates that were chosen before.
bool FieldGaps::IsApart(std::size_t number, std::size_t chosen) const noexcept
{
  const Point& point = this->Points[number];
  const double apart = std::max(0.5 * point.Ball.Radius, this->Apart);
  return std::none_of(this->Candidates.begin(), this->Candidates.begin() + chosen,
                      [&](const Candidate& other)
                      {
                        const Vector3 place = this->Points[other.Number].Place();
                        return (place - point.Place()).norm() < apart;
                      });
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
    const double out = std::max(lifted, -point.Ball.Radius);
    this->Places[n] = pose.PositionWorld + this->Turned * (point.Place() + out * point.Outward);
  }
  this->Solid->AreInside(this->Places.data(), this->Places.size(), this->Inside.data());
}

void FieldGaps::AddFoot(const ToolPose& pose, std::size_t number,
                        PoseConstraints& limits) const noexcept
{
  constexpr int Slides = 3;
  constexpr double Same = 0.1; // of the least distance
  const ToolSkeleton::Ball& ball = this->Points[number].Ball;
  const Vector3 toBall = pose.Orientation * ball.Center;
  Vector3 inward = -(pose.Orientation * this->Points[number].Outward);
  FieldSolid::Wall wall;
  double turned = 1.0; // cosine, by the last slide
  for (int slide = 0; slide < Slides; ++slide)
  {
    const Vector3 place = pose.PositionWorld + toBall - ball.Radius * inward;
    wall = this->Solid->WallNear(place, inward);
    if (!wall.IsKnown)
    {
      return;
    }
    turned = inward.dot(wall.Normal);
    inward = wall.Normal;
  }
  const Vector3 arm = toBall - ball.Radius * wall.Normal;
  const double apart = Same * std::max(ball.Radius, this->Apart);
  const bool isKnown =
      std::any_of(limits.begin() + std::min(this->FirstOwn, limits.Size()), limits.end(),
                  [&](const PoseConstraint& other) { return (other.Arm - arm).norm() < apart; });
  if (!isKnown)
  {
    const double gap = wall.Distance - (1.0 - turned) * ball.Radius; // of the ball from the plane
    this->AddWall(pose, ball, number, {wall.Normal, gap, 0}, limits);
  }
}

double FieldGaps::Gather(const ToolPose& pose, PoseConstraints& limits) noexcept
{
  const double away = this->DistanceToBounds(pose);
  if (away > RigidProxy::Margin)
  {
    return away;
  }
  this->FirstOwn = limits.Size();
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
  this->PlaceAll(pose, -std::max(Slack, 0.25 * this->Solid->VoxelSize()));
  return std::none_of(this->Inside.begin(), this->Inside.end(),
                      [](unsigned char inside) { return inside != 0; });
}
} // namespace palpate
