#pragma once

#include "PalpateShapeModule.h"
#include "ScalarGrid.h"
#include "VoxelMask.h"

namespace palpate
{
/// Conversion of a mask to a field whose zero level is its boundary.
enum class FieldMethod
{
  ShapeInterpolation, ///< distance in each slice, interpolated between slices
  Distance,           ///< distance in three dimensions
  Plain               ///< the mask's own half level
};

/// The method that suits a mask: shape interpolation if one spacing is at least 1.5 times each of
/// the others, otherwise distance in three dimensions.
PALPATESHAPE_EXPORT FieldMethod SuitableMethod(const VoxelMask& mask);

/// A field over the box of `mask`, from -0.5 well outside to +0.5 well inside; its zero level is
/// the boundary, which runs half way between neighbouring voxel centres.
///
/// ShapeInterpolation (after Raya and Udupa, IEEE TMI 9, 1990): in each slice across the coarsest
/// axis the signed in-plane distance, clamped to one slice step, and between slices its linear
/// interpolation, sampled so finely that the steps are about the in-plane spacing. Distance: the
/// signed distance in three dimensions. Both are then mapped to the range above over one in-plane
/// voxel, and smoothed by a Gaussian of standard deviation `smoothing` / 2 voxels along each axis.
/// Plain is neither interpolated nor smoothed.
PALPATESHAPE_EXPORT ScalarGrid BuildField(const VoxelMask& mask, FieldMethod method,
                                          double smoothing);
} // namespace palpate
