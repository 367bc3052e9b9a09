#pragma once

#include "GenusZeroSurface.h"
#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "SphereMapQuality.h"
#include "Status.h"
#include "Vector3.h"
#include "VoxelMask.h"

#include <vector>

namespace palpate
{
/// A closed genus-0 surface of a structure with its place on the parameter sphere: the input of
/// FitSurfaceModel.
struct MappedSurface
{
  IndexedMesh Mesh;                ///< world mm, outward
  std::vector<Vector3> Directions; ///< unit vectors, one per point
  SphereMapQuality Map;
  TopologyReport Topology;     ///< its places are in world mm
  std::vector<LostPlace> Lost; ///< voxels that the surface leaves out; places in world mm
  double RestoredVolume = 0.0; ///< mm^3, see GenusZeroSurface
  double MaskVolume = 0.0;     ///< mm^3
};

struct MappedSurfaceSettings
{
  GenusZeroSettings Surface;
  int Triangles = 10'000;
};

/// Moves a mesh from an image's indices to world mm, where triangles still face outwards.
void MoveToWorld(const IndexToWorld& toWorld, IndexedMesh& mesh);

/// Moves a mesh from mm along a mask's axes, from the centre of its box's first voxel, to world mm,
/// where triangles still face outwards.
void MoveToWorld(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& mesh);

/// Makes the surface of a mask (MakeGenusZeroSurface), coarsens it (DecimateMesh) and maps it to
/// the sphere (ParametriseOnSphere). Fails as those do, and beyond the limits of CheckSphereMap;
/// messages are predicates of the structure or sentences of their own. However much had to be
/// changed: CheckTopology judges that, also of a surface that has no map.
Status MakeMappedSurface(const VoxelMask& mask, const IndexToWorld& toWorld,
                         const MappedSurfaceSettings& settings, const KernelProgress& progress,
                         MappedSurface& surface);
} // namespace palpate
