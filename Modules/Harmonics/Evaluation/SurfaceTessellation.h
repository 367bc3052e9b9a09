#pragma once

#include "IcosahedronDirections.h"
#include "IndexedMesh.h"
#include "SurfaceModel.h"

namespace palpate
{
/// The surface's points (mm) at the directions as parameters, and the directions' triangles.
IndexedMesh Tessellated(const SurfaceModel& surface, const IcosahedronDirections& parameters);
} // namespace palpate
