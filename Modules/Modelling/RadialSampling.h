#pragma once

#include "DirectionCaster.h"
#include "IndexedMesh.h"
#include "RadialSamples.h"
#include "Vector3.h"

namespace palpate
{
/// Area (mm^2) of the surface that a crossing stands for, of a ray with this solid angle (sr):
/// solid angle * distance^2 * cosine of the incidence. The cosine counts as 0.05 or more, since a
/// sample on a surface seen edge-on still locates the surface.
double AreaWeightOf(const IndexedMesh& mesh, const RayCrossing& crossing, const Vector3& direction,
                    double solidAngle);

/// Radii of a closed mesh from `center` along the directions of an icosahedron: the outermost
/// crossings, with AreaWeightOf. Directions without a crossing are left out.
RadialSamples SampleRadially(const IndexedMesh& mesh, const Vector3& center, int frequency);
} // namespace palpate
