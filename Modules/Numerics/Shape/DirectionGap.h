#pragma once

#include "IcosahedronDirections.h"
#include "SphericalTriangle.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
/// The largest angle (rad) from any direction to the closest of these: at most the distance of a
/// triangle's corners from its centre.
inline double LargestGap(const IcosahedronDirections& sphere)
{
  double gap = 0.0;
  for (const auto& [a, b, c] : sphere.Triangles())
  {
    const auto at = [&](int corner)
    { return sphere.Directions()[static_cast<std::size_t>(corner)]; };
    gap = std::max(gap, SphericalTriangle{{at(a), at(b), at(c)}}.Cap().Radius);
  }
  return gap;
}
} // namespace palpate
