#pragma once

#include "BernsteinCrossings.h"
#include "RayPath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
/// How far index coordinates on a ray may be from those of the ray that was asked for.
struct CoordinateRounding
{
  double Origin = 0.0;    ///< of the origin, where it was mapped from the world
  double Direction = 0.0; ///< and of the direction

  double At(const RayPath& path, double t) const noexcept
  {
    // When a plane is crossed takes three roundings, a coordinate two more.
    constexpr double Roundings = 5.0 * std::numeric_limits<double>::epsilon();
    return this->Origin + std::abs(t) * this->Direction + Roundings * (1.0 + path.Magnitude(t));
  }
};

inline double RoundingOfT(double t) noexcept
{
  return 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
}

/// How far the exact polynomial's crossing may be from the one found in its rounded coefficients,
/// as a parameter. `coordinateError` is in voxels.
template <typename Cell>
double ParameterError(const double* polynomial, const Cell& relation, double parameter,
                      double coordinateError) noexcept
{
  constexpr double Roundings = Cell::Degree == 3 ? 40.0 : 400.0; // of one evaluation, generously
  double largest = 0.0;
  for (const double node : relation.Nodes)
  {
    largest = std::max(largest, std::abs(node));
  }
  // A step along an axis changes the value by no more than twice the largest node (a difference).
  const double valueError =
      largest * (Roundings * std::numeric_limits<double>::epsilon() + 3.0 * 2.0 * coordinateError);
  using Polynomial = BernsteinCrossings<Cell::Degree>;
  double slope = 0.0;
  Polynomial::Evaluate(polynomial, parameter, slope);
  double reach = 2.0 * valueError / std::abs(slope);
  if (Polynomial::LargestBend(polynomial) * reach < 0.5 * std::abs(slope))
  {
    return reach;
  }
  // Near a double root the slope alone says too little: widened until the value on both sides is
  // beyond its error.
  constexpr int MostDoublings = 60;
  for (int n = 0; n < MostDoublings && reach < 1.0; ++n, reach *= 2.0)
  {
    const double before = Polynomial::Value(polynomial, std::max(parameter - reach, 0.0));
    const double after = Polynomial::Value(polynomial, std::min(parameter + reach, 1.0));
    if ((std::abs(before) > valueError || parameter <= reach) &&
        (std::abs(after) > valueError || parameter + reach >= 1.0))
    {
      return reach;
    }
  }
  return std::min(reach, 1.0);
}
} // namespace palpate
