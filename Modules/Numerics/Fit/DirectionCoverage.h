#pragma once

#include "LargestEmptyCap.h"
#include "RadialSamples.h"
#include "Status.h"
#include "Vector3.h"

#include <string>
#include <vector>

namespace palpate
{
/// How well directions determine a fit, before anything is measured along them.
struct DirectionCoverage
{
  enum class Verdict
  {
    Good,
    Gaps,        ///< the model is a guess somewhere
    Undetermined ///< coefficients are not determined at all
  };

  /// The largest cap without a direction of positive weight, to a quarter of the mean spacing.
  SphericalCap LargestGap{Vector3::UnitZ(), 0.0};
  /// 2-norm condition number of the weighted design matrix without the penalty.
  double Condition = 0.0;
  ///@{ Deviation of the fitted radius over that of a sample of mean weight, with the penalty: root
  /// mean
  /// square and maximum over the sphere, and where that is. What a penalty leaves out (its bias) is
  /// not in it.
  double NoiseGainRms = 0.0;
  double NoiseGainMaximum = 0.0;
  Vector3 NoiseGainDirection = Vector3::UnitZ();
  ///@}
  Verdict Outcome = Verdict::Undetermined;
  std::string Sentence; ///< the verdict and its reason for people

  /// Largest radius of a gap (rad) that is good: half a wavelength of the highest degree, 180
  /// degrees over the degree. In the middle of a wider one the highest terms can rise and fall
  /// without any sample that notices. Measured: errors inside of a missing cap stay below those
  /// outside up to two thirds of it, are equal at it, and grow tenfold by twice of it.
  static double WidestGap(int degree);
  /// Above it, somewhere the fit is worse than one sample would be.
  static constexpr double HighestNoiseGain = 1.0;
  /// Above it, noise of a tenth of a millimetre moves coefficients by a metre.
  static constexpr double HighestCondition = 1e4;
};

/// Undetermined: without a penalty, a condition above HighestCondition. Gaps: a gap wider than
/// WidestGap, with a penalty or without (a penalty calms the noise in a gap but knows nothing of
/// the organ there), or a maximum of the noise gain above HighestNoiseGain. `strength`: of the
/// roughness penalty of FitSphericalHarmonics, 0 for none. Refuses what CheckSamples refuses and a
/// negative strength. Some milliseconds for 4,002 directions at degree 12.
Status AssessCoverage(const std::vector<Vector3>& directions, const std::vector<double>& weights,
                      int degree, double strength, DirectionCoverage& coverage);
} // namespace palpate
