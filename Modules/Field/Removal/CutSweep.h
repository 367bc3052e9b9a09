#pragma once

#include "CutTool.h"
#include "Vector3.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Pose of a cutting tool: its frame in the world.
struct CutPose
{
  Vector3 PositionWorld = Vector3::Zero(); ///< mm
  Eigen::Quaterniond Orientation = Eigen::Quaterniond::Identity();
};

/// The volume that a tool sweeps from one pose to another: the union of the tool at all poses in
/// between, as the signed distance (mm) to the nearest of them, negative inside. Exact for a
/// sphere; other tools are placed along the path so that none of their points moves more than
/// `step` from one place to the next.
class CutSweep
{
public:
  CutSweep(CutTool tool, const CutPose& from, const CutPose& to, double step);

  double Distance(const Vector3& pointWorld) const noexcept;
  /// Contains the swept volume, mm.
  const Eigen::AlignedBox3d& BoundsWorld() const noexcept { return this->Bounds; }

  bool IsOfSphere() const noexcept { return this->Tool.IsSphere(); }
  double Radius() const noexcept
  {
    return this->Tool.BoundingRadius();
  } ///< of a sphere around the tool
  const Vector3& FromWorld() const noexcept { return this->From; }
  const Vector3& PathWorld() const noexcept { return this->Path; }

private:
  struct Place
  {
    Vector3 PositionWorld;
    Matrix3 ToTool;
  };

  CutTool Tool;
  Vector3 From;
  Vector3 Path;
  double PathSquared;
  std::vector<Place> Places; // of tools other than spheres
  Eigen::AlignedBox3d Bounds;
};
} // namespace palpate
