#pragma once

#include "ShapeField.h"
#include "Status.h"
#include "VoxelMask.h"

namespace palpate
{
struct MaskShapeSettings
{
  /// Of the shape, in voxels (of thick slices: in their pixels): the field is blurred by a Gaussian
  /// of half this standard deviation.
  double Smoothing = 1.0;
  /// About as many cells of the field's grid lie on the surface; 0: the resolution of the voxels,
  /// which is never exceeded.
  int CellsOnSurface = 0;
};

/// The best estimate of the shape that a mask was drawn from: MakeShapeField with
/// ShapeFieldSettings::OfStar, shifted so that its zero level encloses `volume` (mm^3). Fails as
/// MakeShapeField.
Status MakeMaskShape(const VoxelMask& mask, double volume, const MaskShapeSettings& settings,
                     ShapeField& field);
} // namespace palpate
