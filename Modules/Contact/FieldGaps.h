#pragma once

#include "FieldSolid.h"
#include "ToolGaps.h"
#include "ToolShape.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// Gaps to a material of a field. Points of the tool's shell, lifted by Reach, tell by one look-up
/// each where it is near. From the nearest of these, apart from each other, a foot slides on the
/// tool's ball to where the ball faces the wall (the field's level by value and gradient), as that
/// of a sphere does.
class FieldGaps final : public ToolGaps
{
public:
  /// `tool` has a shell and balls.
  FieldGaps(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool,
            const SurfaceFriction& friction);

  double Gather(const ToolPose& pose, PoseConstraints& limits) noexcept override;
  bool IsFreeAt(const ToolPose& pose) noexcept override;
  std::size_t Bytes() const noexcept override
  {
    return sizeof(*this) + this->Points.size() * (sizeof(Point) + sizeof(Vector3) + 1) +
           this->Candidates.size() * sizeof(Candidate);
  }
  bool CanBeDrilled() const noexcept override { return true; }
  void UseSolid(const FieldSolid& solid) noexcept override
  {
    this->Solid = {std::shared_ptr<const FieldSolid>(), &solid}; // does not own it
  }

private:
  // A point of the shell, on a ball in the tool.
  struct Point
  {
    ToolSkeleton::Ball Ball;
    Vector3 Outward; // in the tool's frame

    Vector3 Place() const noexcept { return this->Ball.Center + this->Ball.Radius * this->Outward; }
  };

  // A point that is near, and how far the wall is from it, mm.
  struct Candidate
  {
    double Gap;
    std::size_t Number;
  };

  double DistanceToBounds(const ToolPose& pose) const noexcept;
  void PlaceAll(const ToolPose& pose, double lifted) noexcept;
  void FindCandidates() noexcept;
  bool IsApart(std::size_t number, std::size_t chosen) const noexcept;
  void AddFoot(const ToolPose& pose, std::size_t number, PoseConstraints& limits) const noexcept;

  std::shared_ptr<const FieldSolid> Solid;
  double Extent; // mm
  double Apart;  // mm, of feet
  double Reach;  // mm
  Matrix3 Turned = Matrix3::Identity();
  std::vector<Point> Points;
  std::vector<Vector3> Places; // of the points, in the world
  std::vector<unsigned char> Inside;
  std::vector<Candidate> Candidates;
  std::size_t CandidateCount = 0;
  std::size_t FirstOwn = 0; // of a step's constraints
};
} // namespace palpate
