#pragma once

#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "MaskShape.h"
#include "Status.h"
#include "TopologyReport.h"
#include "VoxelMask.h"

#include <vector>

namespace palpate
{
struct MaskSurfaceSettings
{
  /// Of a surface that a radial model is fitted to: far finer than the details of a model, and
  /// enough for Dice above 0.999 with the mask. More would only take time.
  static constexpr int CellsOfModel = 12000;

  bool IsPlain = false;    ///< the half level of the mask itself, instead of its shape
  MaskShapeSettings Shape; ///< of MakeMaskShape
  int Component = 1;       ///< of voxels that share faces, by descending size; 0 for all
};

/// A closed, oriented, two-manifold surface of a mask.
struct MaskSurface
{
  IndexedMesh Mesh;                     ///< world mm, outward
  std::vector<double> ComponentVolumes; ///< mm^3 of voxels, descending
  double MaskVolume = 0.0;              ///< mm^3 of the voxels of what was chosen, without cavities
  double SurfaceVolume = 0.0;           ///< mm^3 that the mesh encloses, with cavities
  TopologyChange FilledCavities;        ///< Count, Volume and LargestVolume

  /// What a model of this surface does not have of its mask.
  TopologyReport Changes() const;
};

/// Makes the surface of a component of a mask, whose box has a rim of voxels outside: of its shape,
/// at the level that encloses the volume of its voxels and cavities to a part in a thousand, or of
/// its half level. Of one component, only the largest piece is kept. This is what radial models are
/// fitted to, and what meshes of masks are.
///
/// Fails if the mask has no voxels or not this component, where it is too thin to have a surface
/// and as MakeMaskShape; messages are predicates of the structure, or of those kernels.
Status MakeMaskSurface(VoxelMask mask, const IndexToWorld& toWorld,
                       const MaskSurfaceSettings& settings, const KernelProgress& progress,
                       MaskSurface& surface);

/// The boundary of a mask as it is, half way between the centres of voxels inside and outside, in
/// world mm: closed, oriented outwards, with the surfaces of all parts and cavities. Voxels that
/// share only an edge or a corner are apart. Not interpolated between slices: for measurements
/// against the mask itself. Fails for a mask without voxels, and beyond the limit of MarchCubes.
Status MakeMaskBoundary(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& boundary);
} // namespace palpate
