#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// The area (mm^2) of a mesh where `values` (at its points, linear in the triangles) are at most
/// `limit`. Infinite values count as above. The indices must be valid.
double AreaBelow(const IndexedMesh& mesh, const std::vector<double>& values, double limit);
} // namespace palpate
