#pragma once

#include "IcosahedronDirections.h"
#include "RandomShapes.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
/// The body of published comparisons of haptics libraries: 25 mm (1 + 0.15 b), where b is of
/// degrees 3 and 4 and at most 1. Centre off the origin.
inline RadialModel BumpyBody(Random& random)
{
  constexpr double Radius = 25.0; // mm
  constexpr double Height = 0.15;
  std::vector<double> coefficients = RandomCoefficients(random, 4);
  std::fill(coefficients.begin(), coefficients.begin() + 9, 0.0); // degrees 0 to 2
  const RadialModel bumps(4, coefficients, Vector3::Zero());
  double highest = 0.0;
  const IcosahedronDirections sphere(20);
  for (const Vector3& u : sphere.Directions())
  {
    highest = std::max(highest, std::abs(bumps.Radius(u)));
  }
  for (double& c : coefficients)
  {
    c *= Radius * Height / highest;
  }
  coefficients[0] = Radius * std::sqrt(4.0 * M_PI);
  return {4, coefficients, {-40.0, 12.0, 90.0}};
}
} // namespace palpate::test
