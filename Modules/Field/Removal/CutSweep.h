#pragma once

#include "CutTool.h"
#include "Vector3.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Where a cutting tool is: its frame in the world.
struct CutPose
{
  Vector3 PositionWorld = Vector3::Zero(); ///< mm
  Eigen::Quaterniond Orientation = Eigen::Quaterniond::Identity();
};

/// What a tool passes on its way from one pose to another: the union of all its places, as the
/// signed distance (mm) to the nearest of them, negative inside. That of a sphere is exact; other
/// tools stand at places along the way that are at most `step` apart, at any of their points.
class CutSweep
{
public:
  CutSweep(CutTool tool, const CutPose& from, const CutPose& to, double step);

  double Distance(const Vector3& pointWorld) const noexcept;
  /// Holds what the tool passes, mm.
  const Eigen::AlignedBox3d& BoundsWorld() const noexcept { return this->Bounds; }

  bool IsOfSphere() const noexcept { return this->Tool.IsSphere(); }
  double Radius() const noexcept { return this->Tool.BoundingRadius(); } ///< that holds the tool
  const Vector3& FromWorld() const noexcept { return this->From; }
  const Vector3& WayWorld() const noexcept { return this->Way; }

private:
  struct Place
  {
    Vector3 PositionWorld;
    Matrix3 ToTool;
  };

  CutTool Tool;
  Vector3 From;
  Vector3 Way;
  double WaySquared;
  std::vector<Place> Places; // of tools that are no spheres
  Eigen::AlignedBox3d Bounds;
};
} // namespace palpate
