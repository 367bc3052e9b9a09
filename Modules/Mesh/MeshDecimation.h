#pragma once

#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "ReferenceNormals.h"
#include "Status.h"

namespace palpate
{
struct DecimationSettings
{
  int Triangles = 10'000;   ///< at most so many, if the topology allows it
  int RelaxationRounds = 3; ///< flips and tangential smoothing, see RelaxSurface
};

/// Coarsens a closed, oriented manifold by collapsing short edges, at last strictly the shortest,
/// which leaves edges of nearly equal length, then evens out its triangles. Topology is kept:
/// parts, handles, and closedness. So is the volume, but for flips and the few points around spikes
/// (see EdgeCollapser). Triangles are kept from turning over with respect to `normal`, or without a
/// function to the area-weighted normals of the mesh. Where no further edge can be removed more
/// triangles are left than asked for. Deterministic. Needs 60 to 80 bytes per triangle
/// in addition to the mesh, and 0.4 to 3 us per triangle removed, most where few are.
///
/// Fails for settings below 4 triangles, for what HalfEdgeMesh refuses, and if cancelled;
/// `decimated` is then unchanged. It may be the input.
Status DecimateMesh(const IndexedMesh& mesh, const DecimationSettings& settings,
                    const ReferenceNormal& normal, const KernelProgress& progress,
                    IndexedMesh& decimated);
} // namespace palpate
