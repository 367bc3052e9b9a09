#pragma once

#include "CheckedMask.h"
#include "MaskStatistic.h"
#include "RadialProbe.h"

namespace palpate
{
/// What is measured of a mask alone.
struct MeasuredMask
{
  double Milliliters = 0.0;
  Vector3 Centroid = Vector3::Zero(); ///< world, mm; of all voxels
  MaskStatistics Statistics;
  RadialOutline Outline; ///< of the largest part
};

/// Measures a mask that has voxels: MeasureParts, MeasureSlices, MeasureEnds, MeasureNeck, the
/// outline and its residual ("rough"; Amount: percent). Distances are measured in its box, on
/// coarser voxels if that is huge. Const and thread-safe, as `probe` is.
MeasuredMask MeasureMask(CheckedMask mask, const RadialProbe& probe);
} // namespace palpate
