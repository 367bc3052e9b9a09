#pragma once

#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "LostVoxels.h"
#include "ShapeField.h"
#include "Status.h"
#include "TopologyRepair.h"
#include "TopologyReport.h"
#include "VoxelMask.h"

#include <vector>

namespace palpate
{
struct GenusZeroSettings
{
  ShapeFieldSettings Field;
  TopologySettings Topology;
  double LostTolerance = 0.0;   ///< mm; 0: LostVoxelTolerance
  bool RestoreThinParts = true; ///< RestoreVoxels, if voxels are lost without
};

/// A surface of a mask that is a topological sphere, and what had to be changed to make it one.
struct GenusZeroSurface
{
  /// Closed and oriented outward; in mm along the mask's axes, from the centre of the voxel 0, 0, 0
  /// of the mask's box.
  IndexedMesh Mesh;
  ShapeField Field; ///< whose zero level is the mesh
  TopologyReport Topology;
  double RestoredVolume = 0.0; ///< mm^3, of nodes raised to keep thin parts
  std::vector<LostPlace> Lost; ///< voxels that the surface leaves out, the farthest place first
  double MaskVolume = 0.0;     ///< mm^3
  /// mm^3, of the mask and what the repair has added or removed; the mesh's volume is close to it.
  double TargetVolume() const { return this->MaskVolume + this->Topology.AddedVolume(); }
};

/// Makes a surface from a mask: MakeShapeField, a level that gives the surface the mask's volume
/// (LevelOfVolume), RepairTopology, MarchTetrahedra. If it leaves out voxels of the mask
/// (FindLostVoxels) and `RestoreThinParts` is set, thin parts are restored in the field and the
/// last two steps repeated.
///
/// The volume is matched before the repair; afterwards it differs from the mask's by what the
/// repair changed. It is not matched again: the repaired object's surface elsewhere should stay
/// where it is. Time and memory are in proportion to the mask's box and the grid's nodes, about 40
/// bytes for each of the larger.
///
/// This measures and does not judge: a mask of which much is changed passes. Judge the report
/// (CheckTopology) and `Lost`. Fails for bad input, if the object has several large parts
/// (TopologySettings), and if `progress`, which may be empty, returns false.
Status MakeGenusZeroSurface(const VoxelMask& mask, const GenusZeroSettings& settings,
                            const KernelProgress& progress, GenusZeroSurface& surface);
} // namespace palpate
