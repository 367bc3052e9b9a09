#pragma once

#include "ProvenBall.h"
#include "ToolGaps.h"
#include "ToolSkeleton.h"
#include "TouchableRadialModel.h"
#include "TouchableSurfaceModel.h"
#include "WedgePlaces.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
/// Gaps to a radial or surface model. Each ball tracks up to three minima of the distance, its
/// walls, by Newton's method; between small steps a wall is its tangent plane. A ball that is known
/// to fit where it is has one wall. For others the whole surface is searched again where the ball
/// has come so near that a wall which it does not know could be Skin deep in it: nothing else
/// enters a ball, as the last search has proven. A cluster of balls is searched as one, and none of
/// them is asked while nothing is near the cluster.
template <typename Surface>
class OrganGaps final : public ToolGaps
{
public:
  OrganGaps(std::shared_ptr<const Surface> surface, const ToolSkeleton& tool,
            const SurfaceFriction& friction);

  void BeginTick() noexcept override;
  double Gather(const ToolPose& pose, PoseConstraints& limits) noexcept override;
  bool IsFreeAt(const ToolPose& pose) noexcept override;
  std::size_t Bytes() const noexcept override
  {
    return sizeof(*this) + this->Parts.size() * sizeof(Part) + this->Groups.size() * sizeof(Group);
  }

private:
  using ClosestPoint = typename Surface::ClosestPoint;
  static constexpr std::size_t MostWalls = 3;

  struct Part
  {
    ToolSkeleton::Ball Ball;
    std::array<ClosestPoint, MostWalls> Walls{};
    std::size_t WallCount = 0;
    std::size_t NextWall = 0; // replaced if all are in use
    Vector3 TrackedAt = Vector3::Zero();
    ProvenBall Searched;
    ClosestPoint Found{}; // by the last search
    bool HasSearched = false;
  };

  struct Group
  {
    ToolSkeleton::Cluster Cluster;
    ProvenBall Searched;
    ClosestPoint Found{}; // by the last search
    bool HasSearched = false;
  };

  // mm from the ball to the nearest wall of all, at least.
  static double UnknownAt(const Part& part, const Group& group, const Vector3& centerWorld) noexcept
  {
    return std::max(part.Searched.DistanceAt(centerWorld), group.Searched.DistanceAt(centerWorld)) -
           part.Ball.Radius;
  }
  static double GapAt(const Part& part, const ClosestPoint& wall,
                      const Vector3& centerWorld) noexcept
  {
    return wall.SignedDistance + wall.Normal.dot(centerWorld - part.TrackedAt) - part.Ball.Radius;
  }
  bool HasMoved(const Part& part, const Vector3& centerWorld) const noexcept;
  bool FitsWhereItIs(const Part& part) const noexcept;
  double LookAround(Group& group, const Vector3& centerWorld) noexcept;
  bool LookAround(Part& part, const Group& group, const Vector3& centerWorld,
                  PoseConstraints& limits) noexcept;
  void Search(Part& part, const Vector3& centerWorld) noexcept;
  double GatherOf(Part& part, const Group& group, const ToolPose& pose,
                  PoseConstraints& limits) noexcept;
  void Keep(Part& part, const ClosestPoint& found) noexcept;
  void Track(Part& part, const Vector3& centerWorld) noexcept;

  std::shared_ptr<const Surface> Touched;
  bool Fits = false;                         // balls, with Room around them, into every hollow
  std::shared_ptr<const WedgePlaces> Places; // of a surface model: where they do
  std::vector<Part> Parts;
  std::vector<Group> Groups;
  std::size_t First = 0; // the group whose parts may search first in this tick
  int SearchesLeft = 0;  // in this tick
  std::size_t FirstAsked = 0;
};
} // namespace palpate
