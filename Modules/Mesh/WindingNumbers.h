#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The centres of an image's voxels: Origin + i Axes.col(0) + j Axes.col(1) + k Axes.col(2), mm.
struct VoxelCenters
{
  Vector3 Origin = Vector3::Zero();
  Matrix3 Axes = Matrix3::Identity(); ///< one step along i, j and k; may be oblique, left-handed
  std::array<int, 3> Size{};
};

/// How often a closed mesh encloses each voxel centre, i fastest: 1 inside a surface that is
/// oriented outwards, 2 where it overlaps itself, -1 inside one that is inside out; modulo 2^16.
///
/// The points are transformed to the grid's indices and rounded once; for the mesh that they form
/// there the numbers are exact. A centre on the surface counts as if it were moved by infinitely
/// little along i, then by infinitely less along j, then k (simulation of simplicity, Edelsbrunner
/// and Muecke, ACM Trans. Graphics 9 (1990)), so that no centre is counted twice or lost at edges
/// and points. Several nested or overlapping closed parts are allowed. A mesh with holes is not
/// noticed; then the numbers behind a hole along i are wrong (DescribeTopology).
///
/// Fails for coordinates that are not finite or beyond 1e15 voxels, indices out of range, sizes
/// below 1 or of more than 2^33 voxels together, and axes that are not finite or span no volume.
/// Time: that of all crossings of triangles with grid lines along i, and some ns per voxel.
Status FindWindingNumbers(const IndexedMesh& mesh, const VoxelCenters& centers,
                          std::vector<std::int16_t>& numbers);

/// Numbers of voxels of a mesh and of a mask on the same grid.
struct WindingOverlap
{
  std::int64_t Inside = 0; ///< of the mesh: winding number > 0
  std::int64_t Mask = 0;
  std::int64_t Both = 0;      ///< inside and in the mask
  std::int64_t Irregular = 0; ///< winding number neither 0 nor 1

  /// 1 if both are empty.
  double Dice() const noexcept
  {
    const auto sum = static_cast<double>(this->Inside + this->Mask);
    return sum > 0.0 ? 2.0 * static_cast<double>(this->Both) / sum : 1.0;
  }
  /// Of the mask's voxels; may be above 100.
  double IrregularPercent() const noexcept
  {
    return this->Irregular == 0 ? 0.0
                                : 100.0 * static_cast<double>(this->Irregular) /
                                      static_cast<double>(std::max<std::int64_t>(this->Mask, 1));
  }
};

/// `mask` has a value per winding number; 0 is outside.
WindingOverlap CompareWithMask(const std::vector<std::int16_t>& numbers, const std::uint8_t* mask);

/// Of the mask's voxels. Surfaces of organs have up to 0.1 %.
constexpr double LargestIrregularPercent = 1.0;

/// Fails if a surface overlaps itself in more than LargestIrregularPercent of a mask, with a
/// message that is a predicate of the surface.
Status CheckRegularity(const WindingOverlap& overlap);
} // namespace palpate
