#pragma once

#include "ShapeField.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Volume (mm^3) of the points where the field exceeds `level`: exactly that of the closed surface
/// by marching tetrahedra at this level, as long as the level is above all border nodes.
double VolumeAbove(const ShapeField& field, float level);

/// The part of VolumeAbove(field, 0) in the grid's cubes that touch one of `nodes`, none of which
/// is in the grid's outermost layer. `marks` has a byte for each node of the grid, all 0 before and
/// after.
double VolumeAround(const ShapeField& field, const std::vector<std::size_t>& nodes,
                    std::vector<unsigned char>& marks);

/// The level (mm) whose volume is `volume` (mm^3), to 0.01 % within a few steps; the nearest one
/// that was found if the field has none, for example on a plateau. `area` (mm^2) is a guess of the
/// surface's area.
///
/// Matching the volume of the surface, not the number of voxel centres inside it: many centres of
/// rods and boxes have the same distance, so that counts jump.
float LevelOfVolume(const ShapeField& field, double volume, double area);
} // namespace palpate
