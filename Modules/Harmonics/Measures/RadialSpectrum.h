#pragma once

#include "RadialModel.h"

namespace palpate
{
/// Radii (mm) from Lower to Upper.
struct RadiusInterval
{
  double Lower;
  double Upper;
};

/// Certified bounds of a radius function from the power of each degree alone: never too small,
/// including rounding.
///
/// Along a unit tangent, the sums over m of the squares of Y_lm, of its slope and of its second
/// derivative on the great circle are (2l+1) / (4 pi) times 1, k / 2 and k (3k - 2) / 8 with
/// k = l (l+1) (addition theorem; the Taylor series of P_l(cos s)). By Cauchy and Schwarz a degree
/// of power p contributes at most the root of p times that, and some function of the same spectrum
/// attains all of it at one point: no bound from the spectrum is sharper.
///
/// Queries are const, allocation-free and take a few operations. Non-finite coefficients make every
/// bound NaN.
class RadialSpectrum
{
public:
  explicit RadialSpectrum(const RadialModel& model);

  /// Mean of the radius over all directions (mm).
  double MeanRadius() const noexcept { return this->Mean; }
  /// Largest deviation of a radius from the mean (mm).
  double Relief() const noexcept { return this->LargestRelief; }
  /// A Lipschitz constant of the radius: bounds every surface gradient (mm/rad).
  double Slope() const noexcept { return this->LargestSlope; }
  /// Bounds the magnitude of every second derivative along a great circle, and so of every
  /// eigenvalue of the Hessian (mm/rad^2).
  double SecondDerivative() const noexcept { return this->LargestBend; }

  /// Encloses the radius within `angle` (rad) of the direction at which `sample` was evaluated,
  /// including the error of evaluation.
  RadiusInterval RadiusAround(const RadialModel::Sample& sample, double angle) const noexcept;
  /// Bounds the surface gradient within `angle` (rad) of that direction (mm/rad).
  double SlopeAround(const RadialModel::Sample& sample, double angle) const noexcept;
  /// Error bound of an evaluated radius (mm).
  double EvaluationError() const noexcept { return this->RadiusError; }

private:
  double Mean = 0.0;
  double LargestRelief = 0.0;
  double LargestSlope = 0.0;
  double LargestBend = 0.0;
  double RadiusError = 0.0;
  double SlopeError = 0.0;
};
} // namespace palpate
