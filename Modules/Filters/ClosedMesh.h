#pragma once

#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "MeshMending.h"
#include "PalpateFiltersModule.h"
#include "Status.h"
#include "TopologyReport.h"

#include <string>

namespace palpate
{
struct ClosedMeshSettings
{
  int Part = 0;         ///< the only one that counts, by decreasing area, from 1 (KeepPart); 0: all
  bool Repairs = false; ///< by way of voxels, what mends do not close
  double RepairVoxels = 4.0e6; ///< of a repair
  int MostTriangles = 200'000; ///< finer meshes are coarsened (DecimateMesh)
  int FewestTriangles =
      5'000; ///< edges twice as long as those of so many equal triangles are split
};

/// Surface that a repair has added: what is farther from the given surface than two of its voxels.
struct AddedSurface
{
  double AreaPercent = 0.0;           ///< of the area of what was made
  double Distance = 0.0;              ///< mm, of the farthest place from the given surface
  Vector3 Farthest = Vector3::Zero(); ///< mm
};

/// A surface of one part without handles, holes and crossings, made from a triangle mesh.
struct ClosedMesh
{
  IndexedMesh Mesh; ///< mm, outward; points in the order in which triangles use them
  int GivenTriangles = 0;
  MeshMends Mends;
  std::string Fault;       ///< what the repair has removed, as a predicate; empty without a repair
  double VoxelSize = 0.0;  ///< mm, of the repair
  TopologyReport Topology; ///< of the repair, after the mesh was turned into voxels
  AddedSurface Added;      ///< by the repair
};

/// Mends a mesh (MendMesh) and checks that it is closed, without handles and in one part
/// (FaultOfGenusZero), and that no triangles cross (FindMeshCrossings). Otherwise it fails, or with
/// `Repairs` takes the surface of the voxels inside (FindInside, MakeGenusZeroSurface), with parts
/// joined by bridges, but not across the gap from which on a mask counts as several bodies
/// (TopologyLimits). Very fine meshes are coarsened afterwards, and long edges split.
///
/// Equal meshes with other numbers of their points give equal results, so that the format of a file
/// has no influence. Fails, with a predicate of the surface or a sentence, for what cannot be
/// mended, and if `progress`, which may be empty, cancels. 5 million triangles take some 15 s and 1
/// GB.
PALPATEFILTERS_EXPORT Status MakeClosedMesh(IndexedMesh mesh, const ClosedMeshSettings& settings,
                                            const KernelProgress& progress, ClosedMesh& made);
} // namespace palpate
