#pragma once

#include "FacetTree.h"
#include "ProvenBall.h"
#include "ToolGaps.h"
#include "ToolSkeleton.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
/// Gaps to a triangle mesh, from outside: the nearest point of the mesh to each ball's centre. The
/// planes of points that were the nearest shortly before are kept, so that a ball in a groove is
/// held by both of its sides; and between small steps the planes stand for the mesh. A cluster of
/// balls is asked as one while nothing is near it.
class FacetGaps final : public ToolGaps
{
public:
  FacetGaps(std::shared_ptr<const FacetTree> tree, const ToolSkeleton& tool,
            const SurfaceFriction& friction);

  double Gather(const ToolPose& pose, PoseConstraints& limits) noexcept override;
  bool IsFreeAt(const ToolPose& pose) noexcept override;
  std::size_t Bytes() const noexcept override
  {
    return sizeof(*this) + this->Parts.size() * sizeof(Part) + this->Groups.size() * sizeof(Group);
  }

private:
  static constexpr std::size_t MostWalls = 3;
  struct Wall
  {
    Vector3 PointWorld = Vector3::Zero();
    Vector3 Normal = Vector3::UnitZ();
    Vector3 SeenFrom = Vector3::Zero(); // a ball's centre, mm
  };
  struct Part
  {
    ToolSkeleton::Ball Ball;
    std::array<Wall, MostWalls> Walls;
    std::size_t WallCount = 0;
    ProvenBall Seen; // from the last look
  };
  struct Group
  {
    ToolSkeleton::Cluster Cluster;
    ProvenBall Seen;
  };

  static bool HasMoved(const Part& part, const Vector3& centerWorld) noexcept;
  double DistanceOf(Group& group, const Vector3& centerWorld) const noexcept;
  void LookAround(Part& part, const Vector3& centerWorld) const noexcept;
  double GatherOf(std::size_t number, const ToolPose& pose, PoseConstraints& limits) noexcept;

  std::shared_ptr<const FacetTree> Tree;
  std::vector<Part> Parts;
  std::vector<Group> Groups;
};
} // namespace palpate
