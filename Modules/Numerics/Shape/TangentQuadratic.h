#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
/// The quadratic g.s + s.H s / 2 of steps s in a tangent plane, by two orthonormal tangents a, b:
/// what SquaredDistance::LeastChange, which see, needs of a SquaredDistance.
struct TangentQuadratic
{
  double Aa, Ab, Bb; ///< H
  double A, B;       ///< g

  /// Lower bound, at most 0, within the length `reach` > 0.
  double LeastChange(double reach) const noexcept
  {
    const double square = reach * reach;
    const double half = 0.5 * (this->Aa + this->Bb);
    const double determinant = this->Aa * this->Bb - this->Ab * this->Ab;
    const double spread = std::sqrt(std::max(0.0, half * half - determinant));
    const double smallest = half > 0.0 ? determinant / (half + spread) : half - spread;
    if (smallest > 0.0)
    {
      const Step step = this->Shifted(0.0);
      if (step.SquaredLength <= square)
      {
        return 0.5 * step.Slope;
      }
    }
    constexpr int Shifts = 3;
    const double least = 1e-6 * std::abs(half + half);
    double eigenvalue = std::sqrt(this->A * this->A + this->B * this->B) / reach;
    double change = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < Shifts; ++i)
    {
      const double shift = std::max(0.0, std::max(eigenvalue, least) - smallest);
      const Step step = this->Shifted(shift);
      change = std::max(change, 0.5 * (step.Slope - shift * square));
      eigenvalue = (smallest + shift) * std::sqrt(step.SquaredLength) / reach;
    }
    return change;
  }

private:
  struct Step
  {
    double Slope; // g.s
    double SquaredLength;
  };
  // To the minimum with `shift` times the identity added to H.
  Step Shifted(double shift) const noexcept
  {
    const double aa = this->Aa + shift;
    const double bb = this->Bb + shift;
    const double scale = 1.0 / (aa * bb - this->Ab * this->Ab);
    const double a = scale * (this->Ab * this->B - bb * this->A);
    const double b = scale * (this->Ab * this->A - aa * this->B);
    return {this->A * a + this->B * b, a * a + b * b};
  }
};
} // namespace palpate
