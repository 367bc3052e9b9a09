#pragma once

#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// Triangles by indices into a list of points. Of a closed surface they run counter-clockwise seen
/// from outside.
struct IndexedMesh
{
  std::vector<Vector3> Points;
  std::vector<std::array<int, 3>> Triangles;
};
} // namespace palpate
