#pragma once

#include "FieldSolid.h"
#include "ToolPose.h"
#include "ToolShape.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A tool's shell in its current orientation, and which of its points are inside a solid. All
/// memory is allocated at construction.
class ToolShell
{
public:
  /// The tool must have a shell.
  explicit ToolShell(const ToolShape& tool);

  /// Returns false if the orientation is unchanged.
  bool Turn(const Eigen::Quaterniond& orientation) noexcept;

  /// On the heap.
  std::size_t Bytes() const noexcept
  {
    return this->Count() * (5 * sizeof(Vector3) + sizeof(unsigned char));
  }
  std::size_t Count() const noexcept { return this->Offsets.size(); }
  /// From the tool's origin to its points, mm.
  const Vector3& Offset(std::size_t point) const noexcept { return this->Offsets[point]; }
  const Vector3& InwardNormal(std::size_t point) const noexcept { return this->Inward[point]; }

  /// Number of points inside with the tool's origin at this position; IsInside then tells which.
  int CountInside(const FieldSolid& solid, const Vector3& positionWorld) noexcept;
  bool IsInside(std::size_t point) const noexcept { return this->Inside[point] != 0; }
  /// The fraction of the path from this position after which the first point enters; 1 if none
  /// does.
  double PartToEntry(const FieldSolid& solid, const Vector3& positionWorld,
                     const Vector3& path) const noexcept;

private:
  std::vector<Vector3> ToolPoints;
  std::vector<Vector3> ToolNormals;
  Eigen::Quaterniond Orientation = Eigen::Quaterniond::Identity();
  std::vector<Vector3> Offsets;
  std::vector<Vector3> Inward;
  std::vector<Vector3> PointsWorld;
  std::vector<unsigned char> Inside;
};
} // namespace palpate
