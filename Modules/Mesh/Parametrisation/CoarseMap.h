#pragma once

#include "KernelProgress.h"
#include "MappedVertex.h"
#include "VertexRings.h"

#include <vector>

namespace palpate
{
/// Maps a surface of some hundred vertices, those of `rings`, to the sphere with little energy.
///
/// Bent surfaces have several maps of locally least energy, in which a horn lies to one side or to
/// the other. Which one a descent finds depends on the simplification that it starts from, hence on
/// noise; so several simplifications are tried, and the map of the least energy is kept. Surfaces
/// like a sphere have one map: the first trial does. False if all degenerate, or if `progress`
/// cancels.
bool MapCoarseSurface(const VertexRings& rings, const KernelProgress& progress,
                      std::vector<MappedVertex>& vertices);
} // namespace palpate
