#include "RadialSpectrum.h"

#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
// Bound of the evaluation error at every degree, verified against 50 digits, in units of the
// largest value that coefficients of this length allow.
constexpr double EvaluationTolerance = 1e-12;

// Largest magnitude, or NaN if any entry is not finite.
double LargestOf(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    if (!std::isfinite(value))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

// Length of the coefficients of one degree in units of `unit`, which keeps squares in range.
double Amplitude(const std::vector<double>& coefficients, int l, double unit)
{
  double sum = 0.0;
  for (int m = -l; m <= l; ++m)
  {
    const double c = coefficients[SphericalHarmonicBasis::Index(l, m)] / unit;
    sum += c * c;
  }
  return std::sqrt(sum);
}
} // namespace

RadialSpectrum::RadialSpectrum(const RadialModel& model)
    : Mean(model.Coefficients()[0] / std::sqrt(4.0 * M_PI))
{
  const double largest = LargestOf(model.Coefficients());
  const double unit = largest == 0.0 ? 1.0 : largest;
  // Sums of positive terms, each with at most 2L + 1 squares and a few operations more.
  const double roundUp =
      1.0 + (4.0 * model.Degree() + 32.0) * std::numeric_limits<double>::epsilon();
  double length = 0.0; // squared, of the coefficients seen so far
  double relief = 0.0;
  double slope = 0.0;
  double bend = 0.0;
  double slopeScale = 0.0; // squared
  for (int l = model.Degree(); l >= 0; --l)
  {
    const double k = static_cast<double>(l) * (l + 1);
    const double share = (2 * l + 1) / (4.0 * M_PI);
    const double amplitude = Amplitude(model.Coefficients(), l, unit);
    const double reach = amplitude * std::sqrt(share);
    relief += l > 0 ? reach : 0.0;
    slope += reach * std::sqrt(k / 2);
    bend += reach * std::sqrt(k * (3 * k - 2) / 8);
    length += amplitude * amplitude;
    slopeScale += share * k / 2;
  }
  this->LargestRelief = unit * relief * roundUp;
  this->LargestSlope = unit * slope * roundUp;
  this->LargestBend = unit * bend * roundUp;
  const double error = EvaluationTolerance * unit * std::sqrt(length);
  this->RadiusError = error * (model.Degree() + 1) / std::sqrt(4.0 * M_PI);
  this->SlopeError = error * std::sqrt(slopeScale);
}

RadiusInterval RadialSpectrum::RadiusAround(const RadialModel::Sample& sample,
                                            double angle) const noexcept
{
  // Taylor's formula along the great circle to any direction within the angle.
  const double slope = sample.SurfaceGradient.norm() + this->SlopeError;
  const double reach =
      std::min(slope * angle + 0.5 * this->LargestBend * angle * angle, this->LargestSlope * angle);
  const double relief = this->Relief() + this->RadiusError;
  // Arguments ordered so that NaN propagates.
  return {std::max(sample.Radius - reach - this->RadiusError, this->Mean - relief),
          std::min(sample.Radius + reach + this->RadiusError, this->Mean + relief)};
}

double RadialSpectrum::SlopeAround(const RadialModel::Sample& sample, double angle) const noexcept
{
  return std::min(sample.SurfaceGradient.norm() + this->SlopeError + this->LargestBend * angle,
                  this->LargestSlope);
}
} // namespace palpate
