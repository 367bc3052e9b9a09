#pragma once

#include "Status.h"
#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// What the guard of SlideDirections did, in vertices.
struct DirectionSlide
{
  int Halved = 0;   ///< moved by a half or less of the step, but moved
  int Reverted = 0; ///< not moved, although a step was wished
};

/// Moves directions along the unit sphere (refit of a parametrisation) without folding the map.
///
/// `steps` are tangent vectors in rad, one per direction; radial parts are ignored, and steps above
/// `longestStep` shortened. Each direction follows its great circle. Where a triangle's determinant
/// would fall below `leastShare` of what it was, its corners' steps are halved, five times at most,
/// then reverted: so every triangle keeps its orientation and the map stays bijective, which is
/// verified. Fails, and leaves `directions` alone, if sizes do not match, a step is not finite or
/// the map is not bijective.
Status SlideDirections(const std::vector<std::array<int, 3>>& triangles,
                       const std::vector<Vector3>& steps, double longestStep, double leastShare,
                       std::vector<Vector3>& directions, DirectionSlide& slide);
} // namespace palpate
