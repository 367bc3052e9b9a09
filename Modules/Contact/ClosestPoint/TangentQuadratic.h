#pragma once

#include "FourLanes.h"

#include <limits>
#include <type_traits>

namespace palpate
{
/// The quadratic g.s + s.H s / 2 of steps s in a tangent plane, by two orthonormal tangents a, b:
/// what SquaredDistance::LeastChange, which see, needs of a SquaredDistance. One (`Number` is
/// double) or four at once (FourLanes).
template <typename Number>
struct TangentQuadratic
{
  Number Aa, Ab, Bb; ///< H
  Number A, B;       ///< g

  /// A lower bound, at most 0, within the length `reach` > 0.
  void LeastChange(const Number& reach, Number& change) const noexcept
  {
    const Number square = reach * reach;
    const Number half = 0.5 * (this->Aa + this->Bb);
    const Number determinant = this->Aa * this->Bb - this->Ab * this->Ab;
    Number spread, slope, squaredLength, length;
    SquareRoot(half * half - determinant, spread);
    const Number smallest = half > 0.0 ? determinant / (half + spread) : half - spread;
    this->Step(Number{}, slope, squaredLength);
    const Number within = 0.5 * slope;
    if constexpr (std::is_same_v<Number, double>)
    {
      if (smallest > 0.0 && squaredLength <= square)
      {
        change = within;
        return;
      }
    }
    const auto isShort = squaredLength <= square;
    const Number least = (half > 0.0 ? 2e-6 * half : -2e-6 * half) - smallest;
    const Number perReach = 1.0 / reach;
    SquareRoot(this->A * this->A + this->B * this->B, length);
    Number shift = length * perReach - smallest; // the step is then no longer
    change = Number{} - std::numeric_limits<double>::infinity();
    constexpr int Shifts = 3;
    for (int i = 0; i < Shifts; ++i)
    {
      shift = shift > least ? shift : least;
      shift = shift > 0.0 ? shift : Number{};
      this->Step(shift, slope, squaredLength);
      const Number dual = 0.5 * (slope - shift * square);
      change = dual > change ? dual : change;
      SquareRoot(squaredLength, length);
      shift = (smallest + shift) * length * perReach - smallest;
    }
    const Number convex = isShort ? within : change;
    change = smallest > 0.0 ? convex : change;
  }

private:
  // To the minimum with `shift` times the identity added to H; the slope is g.s.
  void Step(const Number& shift, Number& slope, Number& squaredLength) const noexcept
  {
    const Number aa = this->Aa + shift;
    const Number bb = this->Bb + shift;
    const Number scale = 1.0 / (aa * bb - this->Ab * this->Ab);
    const Number a = scale * (this->Ab * this->B - bb * this->A);
    const Number b = scale * (this->Ab * this->A - aa * this->B);
    slope = this->A * a + this->B * b;
    squaredLength = a * a + b * b;
  }
};
} // namespace palpate
