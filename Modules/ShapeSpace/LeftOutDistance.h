#pragma once

#include "LeftOutModes.h"

#include <Eigen/Core>

namespace palpate
{
/// How far a case lies from all others of its group, in units of their variation.
struct LeftOutDistance
{
  Eigen::Index ModeCount = 0; ///< of the others, which describe the case
  double Mahalanobis = 0.0;   ///< root of the sum of squared scores over their variances
  ///@{ Hotelling's statistic for one new case of a normal population and its degrees of freedom:
  /// F exceeds what was found with the probability p of a case that is as far or farther. Exact if
  /// the modes were fixed in advance or describe everything. They are estimated from the others, so
  /// that F is too small otherwise; LeftOutProbabilities corrects it.
  double F = 0.0;
  double NumeratorDegrees = 0.0;
  double DenominatorDegrees = 0.0;
  ///@}
  double Outside = 0.0; ///< distance from what these modes can describe, RMS over the sphere, mm
};

/// How many modes such distances use: CountStableModes of the other cases.
Eigen::Index CountDistanceModes(const ShapeModes& modes);

/// The distance in the first `count` of the others' modes, all that they have at most; of a group
/// of `cases`. All 0 if the others have no modes. (Mardia, Kent and Bibby, Multivariate Analysis,
/// 1979, ch. 3: a case minus the mean of m others has m + 1 over m times the variance.)
LeftOutDistance DistanceFromOthers(const LeftOutModes& others, Eigen::Index count,
                                   Eigen::Index cases);
} // namespace palpate
