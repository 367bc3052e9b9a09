#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
/// The quadratic g.s + s.H s / 2 of steps s in a tangent plane, by two orthonormal tangents a, b:
/// what SquaredDistance::LeastChange (see there) needs of a SquaredDistance.
struct TangentQuadratic
{
  double Aa, Ab, Bb; ///< H
  double A, B;       ///< g

  /// A lower bound, at most 0, within the length `reach` > 0.
  double LeastChange(double reach) const noexcept
  {
    const double square = reach * reach;
    const double half = 0.5 * (this->Aa + this->Bb);
    const double determinant = this->Aa * this->Bb - this->Ab * this->Ab;
    const double spread = std::sqrt(std::max(0.0, half * half - determinant));
    const double smallest = half > 0.0 ? determinant / (half + spread) : half - spread;
    double slope = 0.0;
    double squaredLength = 0.0;
    this->Step(0.0, slope, squaredLength);
    if (smallest > 0.0 && squaredLength <= square)
    {
      return 0.5 * slope;
    }
    const double least = 2e-6 * std::abs(half) - smallest;
    double shift = std::hypot(this->A, this->B) / reach - smallest; // the step is then no longer
    double change = -std::numeric_limits<double>::infinity();
    constexpr int Shifts = 3;
    for (int i = 0; i < Shifts; ++i)
    {
      shift = std::max({0.0, shift, least});
      this->Step(shift, slope, squaredLength);
      change = std::max(change, 0.5 * (slope - shift * square));
      shift = (smallest + shift) * std::sqrt(squaredLength) / reach - smallest;
    }
    return change;
  }

private:
  // To the minimum with `shift` times the identity added to H; the slope is g.s.
  void Step(double shift, double& slope, double& squaredLength) const noexcept
  {
    const double aa = this->Aa + shift;
    const double bb = this->Bb + shift;
    const double scale = 1.0 / (aa * bb - this->Ab * this->Ab);
    const double a = scale * (this->Ab * this->B - bb * this->A);
    const double b = scale * (this->Ab * this->A - aa * this->B);
    slope = this->A * a + this->B * b;
    squaredLength = a * a + b * b;
  }
};
} // namespace palpate
