#pragma once

#include "ComplianceMaps.h"
#include "RadialModel.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// How hard the places of an organ that yields feel: the force on a ball at a fixed depth, and by
/// how much a hand notices that it differs from the organ's median.
struct FeltStiffness
{
  /// Of the ball's radius, but at most 0.1 of the organ's mean radius: well within what linear
  /// elasticity is said to hold for.
  static constexpr double DepthOfBall = 0.25;

  double Depth = 0.0;  ///< mm
  double Median = 0.0; ///< N, over the organ's places where the force is valid; NaN if nowhere
  double Least = 0.0;  ///< N, there
  double Most = 0.0;   ///< N, there
  /// N in each direction; NaN where the force is not valid (see ElasticForce).
  std::vector<double> Forces;
  /// Just noticeable differences from the median; NaN where the force is.
  std::vector<double> Noticed;

  /// For a ball of `ballRadius` mm, in these unit vectors from the model's centre. The median is
  /// over places spread evenly, whatever the directions are. Allocates.
  static FeltStiffness Of(const RadialModel& model, const ComplianceMaps& maps, double ballRadius,
                          const std::vector<Vector3>& directions);
};
} // namespace palpate
