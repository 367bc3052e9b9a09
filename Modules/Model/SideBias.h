#pragma once

#include "DistanceSamples.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// The signed distance of a surface from another, by where its points lie as seen from a centre, in
/// patient LPS. A side has the points that lie farther along its axis than along the other two, an
/// octant those with three signs.
struct SideBias
{
  struct Part
  {
    double Mean = 0.0;  ///< mm; NaN without area
    double Share = 0.0; ///< of the surface's area
  };
  /// +x, -x, +y, -y, +z, -z: left, right, posterior, anterior, superior, inferior.
  std::array<Part, 6> Sides;
  /// Bit 0: right instead of left, bit 1: anterior instead of posterior, bit 2: inferior instead of
  /// superior.
  std::array<Part, 8> Octants;

  static SideBias Of(const DistanceSamples& samples, const Vector3& center);
};
} // namespace palpate
