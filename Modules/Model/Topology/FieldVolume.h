#pragma once

#include "ShapeField.h"

#include <cstddef>
#include <functional>
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

/// What a level is searched for.
struct LevelSearch
{
  double Lowest = 0.0;  ///< of the field
  double Highest = 0.0; ///< of the field
  double Volume = 0.0;  ///< mm^3, wanted
  double Area = 0.0;    ///< mm^2, a guess of the surface's area
  double Tolerance = 1e-4;
  int MaximumSteps = 40;
};

/// The level (mm) at which `volumeAbove` is the wanted one, to the tolerance within a few steps
/// from level 0; the nearest one that was found if the field has none, for example on a plateau.
double FindLevel(const LevelSearch& search, const std::function<double(double level)>& volumeAbove);

/// The level (mm) whose VolumeAbove is `volume` (mm^3), to 0.01 %; see FindLevel.
///
/// Matching the volume of the surface, not the number of voxel centres inside it: many centres of
/// rods and boxes have the same distance, so that counts jump.
float LevelOfVolume(const ShapeField& field, double volume, double area);
} // namespace palpate
