#pragma once

#include "IcosahedronDirections.h"
#include "IndexedMesh.h"
#include "ParametricSphericalSurface.h"

namespace palpate
{
/// The surface's points (mm) at the directions as parameters, and the directions' triangles.
IndexedMesh Tessellated(const ParametricSphericalSurface& surface,
                        const IcosahedronDirections& parameters);
} // namespace palpate
