#pragma once

#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "NearestOnMesh.h"
#include "Status.h"
#include "VoxelMask.h"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace palpate
{
/// A mask whose surface is moved, voxel by voxel on its own grid. The surface is the shape that the
/// mask was drawn from (MakeMaskSurface, all parts), or the mask's boundary where it is too thin
/// for that. Immutable.
class MaskCorrection
{
public:
  static constexpr double LeastDisplacement = 0.05; ///< mm; less changes no voxel

  /// Whether a voxel (image index) must not be added, such as one of a neighbour.
  using Barrier = std::function<bool(const std::array<int, 3>& index)>;

  /// `mask` is of an image of this size and has a rim of voxels outside. Fails for a mask without
  /// voxels and as MakeMaskBoundary does. Allocates.
  static Status Make(VoxelMask mask, const IndexToWorld& toWorld,
                     const std::array<int, 3>& imageSize, MaskCorrection& made);

  const IndexedMesh& Surface() const noexcept { return this->Mesh; } ///< world mm, outward
  const std::vector<Vector3>& Normals() const noexcept { return this->Outward; } ///< of its points
  const VoxelMask& Mask() const noexcept { return this->Start; }

  /// The mask after its surface's points moved along their normals (mm, one number each): a voxel
  /// whose centre is at the signed distance t from the surface, and next to a point that moved by
  /// d, is inside where t < d. Where |d| is below LeastDisplacement, and beyond d, voxels stay as
  /// they were, so do cavities and loose parts; where d > 0 none is removed, where d < 0 none
  /// added. What is added hangs together, over faces, with the mask and stays in the image and
  /// outside of the barrier. The box of the result is that of the mask or larger, with a rim.
  /// Allocates; some 0.5 us for each voxel of the box around what moved.
  VoxelMask Moved(const Eigen::VectorXd& displacements, const Barrier& barrier = {}) const;

private:
  struct Box;
  Box BoxOf(const Eigen::VectorXd& displacements) const;
  double SignedDistance(const NearestOnMesh::Result& nearest, const Vector3& point,
                        const Eigen::VectorXd& displacements, double& moved) const noexcept;
  void MoveSlice(int k, const Box& box, const Eigen::VectorXd& displacements,
                 const Barrier& barrier, VoxelMask& moved) const;

  VoxelMask Start;
  IndexToWorld ToWorld;
  std::array<int, 3> ImageSize{};
  IndexedMesh Mesh;
  std::vector<Vector3> Outward;
  NearestOnMesh Nearest;
};

/// The unit normals of a mesh's points: sums of the area vectors of their triangles; zero where
/// those vanish.
std::vector<Vector3> PointNormals(const IndexedMesh& mesh);
} // namespace palpate
