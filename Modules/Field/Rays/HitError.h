#pragma once

#include "BernsteinCrossings.h"
#include "RayPath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
/// Rounding error of index coordinates on a ray, relative to those of the requested ray.
struct CoordinateRounding
{
  double Origin = 0.0;    ///< of the origin, if mapped from the world
  double Direction = 0.0; ///< of the direction

  double At(const RayPath& path, double t) const noexcept
  {
    // The parameter of a plane's crossing takes three roundings, a coordinate two more.
    constexpr double Roundings = 5.0 * std::numeric_limits<double>::epsilon();
    return this->Origin + std::abs(t) * this->Direction + Roundings * (1.0 + path.Magnitude(t));
  }
};

inline double RoundingOfT(double t) noexcept
{
  return 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
}

/// Bound of the difference, as a parameter, between the exact polynomial's crossing and the one
/// found with its rounded coefficients. `coordinateError` is in voxels.
template <typename Cell>
double ParameterError(const double* polynomial, const Cell& relation, double parameter,
                      double coordinateError) noexcept
{
  constexpr double Roundings = Cell::Degree == 3 ? 40.0 : 400.0; // of one evaluation, with a margin
  double largest = 0.0;
  for (const double node : relation.Nodes)
  {
    largest = std::max(largest, std::abs(node));
  }
  // A step along an axis changes the value by at most twice the largest node (a difference).
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
  // Near a double root the slope alone underestimates the error: the interval is widened until the
  // value on both sides exceeds its error.
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
