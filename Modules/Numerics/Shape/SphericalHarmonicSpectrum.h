#pragma once

#include "SphericalHarmonicModel.h"

#include <vector>

namespace palpate
{
/// Radii (mm) from Lower to Upper.
struct RadiusInterval
{
  double Lower;
  double Upper;
};

/// What the power of each degree alone guarantees about a radius function: certified bounds, never
/// too small, rounding included.
///
/// Along a unit tangent, sum over m of the squares of Y_lm, of its slope and of its second
/// derivative on the great circle are (2l+1) / (4 pi) times 1, k / 2 and k (3k - 2) / 8 with
/// k = l (l+1) (addition theorem; the Taylor series of P_l(cos s)). By Cauchy and Schwarz a degree
/// of power p contributes at most the root of p times that, and some function of the same spectrum
/// attains all of it at one point: no bound from the spectrum is sharper.
///
/// Queries are const, free of allocation and cost a few operations. Coefficients that are not
/// finite make every bound NaN.
class SphericalHarmonicSpectrum
{
public:
  explicit SphericalHarmonicSpectrum(const SphericalHarmonicModel& model);

  int Degree() const noexcept { return static_cast<int>(this->Tails.size()) - 1; }
  /// Mean of the radius over all directions (mm).
  double MeanRadius() const noexcept { return this->Mean; }
  /// No radius differs from the mean by more (mm).
  double Relief() const noexcept { return this->Tails.front().Maximum; }
  /// A Lipschitz constant of the radius: no surface gradient is longer (mm/rad).
  double Slope() const noexcept { return this->LargestSlope; }
  /// No second derivative along a great circle, so no eigenvalue of the Hessian, is larger in
  /// magnitude (mm/rad^2).
  double SecondDerivative() const noexcept { return this->LargestBend; }

  /// What is lost where all terms above a degree are left out (mm).
  struct TruncationError
  {
    double Rms;     ///< root mean square over all directions: exact up to rounding (Parseval)
    double Maximum; ///< certified bound of the largest error
  };
  /// `degree` from 0 to Degree().
  TruncationError Truncation(int degree) const noexcept
  {
    return this->Tails[static_cast<std::size_t>(degree)];
  }

  /// Encloses the radius within `angle` (rad) of the direction that `sample` was evaluated at, the
  /// error of evaluation included.
  RadiusInterval RadiusAround(const SphericalHarmonicModel::Sample& sample,
                              double angle) const noexcept;
  /// No surface gradient within `angle` (rad) of that direction is longer (mm/rad).
  double SlopeAround(const SphericalHarmonicModel::Sample& sample, double angle) const noexcept;
  /// What an evaluated radius may be wrong by (mm).
  double EvaluationError() const noexcept { return this->RadiusError; }

private:
  double Mean = 0.0;
  double LargestSlope = 0.0;
  double LargestBend = 0.0;
  double RadiusError = 0.0;
  double SlopeError = 0.0;
  std::vector<TruncationError> Tails;
};
} // namespace palpate
