#pragma once

#include "ComparedBody.h"
#include "IndexedMesh.h"

#include <array>

namespace palpate
{
/// The surface of a mask without where the border of its image cuts it. `size` is the image's,
/// voxels. A triangle is a part of the cut if its centre is nearer to the border, from at most two
/// voxels away, than to the edge of the mask in the image's last layer, since the surface of a
/// mask's shape rounds the edge of the cut. All points stay.
IndexedMesh WithoutCut(const IndexedMesh& surface, const PlacedMask& mask,
                       const std::array<int, 3>& size);

/// The area of what WithoutCut leaves out, mm^2.
double CutAreaOf(const IndexedMesh& surface, const PlacedMask& mask,
                 const std::array<int, 3>& size);
} // namespace palpate
