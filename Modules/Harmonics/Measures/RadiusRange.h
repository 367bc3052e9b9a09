#pragma once

#include "RadialModel.h"

namespace palpate
{
/// The smallest and the largest radius of a model (mm), enclosed from both sides: the smallest is
/// in [Lower, LowestFound], the largest in [HighestFound, Upper]. Certified, including rounding.
struct RadiusRange
{
  double Lower;
  double LowestFound;  ///< the model has this radius somewhere
  double HighestFound; ///< and this one
  double Upper;
};

/// Searches the whole sphere by branch and bound: triangles of great circles are split, the most
/// promising first, until the remaining uncertainty is less than `tolerance` (mm). Some thousands
/// of evaluations for an organ of degree 12 and 1e-3 mm; after a million it returns the bounds
/// reached so far (a ring or a field of equal extremes takes many). Allocates: for preparation, not
/// for the servo thread. Non-finite coefficients give NaN.
RadiusRange FindRadiusRange(const RadialModel& model, double tolerance);
} // namespace palpate
