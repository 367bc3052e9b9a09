#pragma once

#include "IndexToWorld.h"
#include "Status.h"
#include "VoxelMask.h"

#include <array>

namespace palpate::bench
{
/// A mask and its place in the patient.
struct PlacedLabel
{
  VoxelMask Mask;
  IndexToWorld ToWorld;
};

/// How far the same parameter is from itself (mm, over 1,002 parameters) in surface models of
/// degree 12 of a mask and of its variants.
struct SurfaceCorrespondence
{
  struct Distance
  {
    double Mean = 0.0;
    double Largest = 0.0;
    double FarShare = 0.0; ///< of the parameters, those that are more than 5 mm apart
  };
  Distance Noise;  ///< 15 % of the voxels at the boundary of slices flipped
  Distance Grid;   ///< a working grid that is 1.17 times as coarse
  Distance Mirror; ///< the body mirrored left to right, with the mirrored parameter
  std::array<Distance, 3> All() const { return {this->Noise, this->Grid, this->Mirror}; }
};

/// Fails where the mask, or one of its variants, has no model by the limits of a fit; without these
/// limits if `isRepaired`.
Status MeasureCorrespondence(const PlacedLabel& label, bool isRepaired,
                             SurfaceCorrespondence& correspondence);
} // namespace palpate::bench
