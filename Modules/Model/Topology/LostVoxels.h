#pragma once

#include "IndexedMesh.h"
#include "ShapeField.h"
#include "VoxelMask.h"

#include <vector>

namespace palpate
{
/// Voxels of a mask that a surface leaves out, connected by the 26 neighbours: ends of a mask that
/// are thinner than the grid's spacing, or parts that were dropped. Overlap measures hardly see
/// them.
struct LostPlace
{
  std::vector<std::size_t> Voxels;   ///< offsets in the mask
  double Distance = 0.0;             ///< mm from the surface, of the farthest voxel's centre
  Vector3 Farthest{Vector3::Zero()}; ///< that centre, in mm (ShapeGrid's frame)
  /// The place is a part of its own already in the mask: no path of voxels leads to those that are
  /// inside the surface.
  bool IsSeparate = false;
};

/// 1.5 times the diagonal of the mask's pixels (the two finest axes), and at least 1.5 grid
/// spacings. The centre of a corner voxel is within half a diagonal of the boundary half way
/// between centres, and a surface on the grid cuts corners by about as much; what exceeds three
/// times that is missing, not rounded.
double LostVoxelTolerance(const VoxelMask& mask, const ShapeGrid& grid);

/// The voxels inside the mask whose centres are outside of the field and farther than `tolerance`
/// (mm) from its surface `mesh`; the farthest place first. Distances are to the mesh's vertices,
/// which lie within half a spacing of any of its points.
std::vector<LostPlace> FindLostVoxels(const VoxelMask& mask, const ShapeField& field,
                                      const IndexedMesh& mesh, double tolerance);

/// Raises nodes of `field` to 0.15 spacings inside along the voxels of the places that are not
/// separate and those that lead from them to the rest of the object: voxels of the mask with their
/// centres outside of `repaired`, and one voxel beyond. So ends that fall between the grid's nodes
/// become strands of one node instead of nothing. `repaired` is the field in which the places were
/// found, `field` the same before its topology was repaired. Returns the number of nodes raised;
/// the outermost layer of the grid is left alone.
std::size_t RestoreVoxels(const VoxelMask& mask, const std::vector<LostPlace>& places,
                          const ShapeField& repaired, ShapeField& field);
} // namespace palpate
