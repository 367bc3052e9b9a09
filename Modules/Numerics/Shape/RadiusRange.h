#pragma once

#include "SphericalHarmonicModel.h"

namespace palpate
{
/// The smallest and the largest radius of a model (mm), enclosed from both sides: the smallest is
/// from Lower to LowestFound, the largest from HighestFound to Upper. Certified, rounding included.
struct RadiusRange
{
  double Lower;
  double LowestFound;  ///< the model has this radius somewhere
  double HighestFound; ///< and this one
  double Upper;
};

/// Searches the whole sphere by branch and bound: triangles of great circles are split, the most
/// promising first, until what they may still hide is less than `tolerance` (mm). Some thousands of
/// evaluations for an organ of degree 12 and 1e-3 mm; after a million it returns what is certain by
/// then (a ring or a field of equal extremes takes many). Allocates: for preparation, not for the
/// servo thread. Coefficients that are not finite give NaN.
RadiusRange FindRadiusRange(const SphericalHarmonicModel& model, double tolerance);
} // namespace palpate
