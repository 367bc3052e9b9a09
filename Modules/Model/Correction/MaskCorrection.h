#pragma once

#include "IndexToWorld.h"
#include "IndexedMesh.h"
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

  /// The mask after its surface's points moved (mm, a column each): voxels whose centres lie
  /// between the surface before and after are added or removed, and with them those next to such
  /// voxels that the surface, which is smoother than the mask, has on the same side. All others
  /// stay as they were, and motions below LeastDisplacement count as none. What is added hangs
  /// together, over faces, with the mask and stays in the image and outside of the barrier. The box
  /// of the result is that of the mask or larger, with a rim. Allocates; some 10 ns for each voxel
  /// of the box around what moved.
  VoxelMask Moved(const Eigen::Matrix3Xd& displacements, const Barrier& barrier = {}) const;

private:
  struct Box;
  Box BoxOf(const IndexedMesh& after) const;
  void Change(const Box& box, const IndexedMesh& after, const Barrier& barrier,
              VoxelMask& moved) const;

  VoxelMask Start;
  IndexToWorld ToWorld;
  std::array<int, 3> ImageSize{};
  IndexedMesh Mesh;
  std::vector<Vector3> Outward;
};

/// The unit normals of a mesh's points: sums of the area vectors of their triangles; zero where
/// those vanish.
std::vector<Vector3> PointNormals(const IndexedMesh& mesh);
} // namespace palpate
