#pragma once

#include "RadialModel.h"
#include "SphericalHarmonicBasis.h"
#include "Vector3.h"

#include <cmath>
#include <random>
#include <vector>

namespace palpate::test
{
/// Seeded random cases for property tests. The seed is part of each test, so a failure is
/// repeatable.
using Random = std::mt19937_64;

/// A unit vector, uniform on the sphere.
inline Vector3 RandomDirection(Random& random)
{
  std::normal_distribution<double> normal;
  Vector3 v;
  do
  {
    v = {normal(random), normal(random), normal(random)};
  } while (v.norm() < 1e-3);
  return v.normalized();
}

inline std::vector<Vector3> RandomDirections(Random& random, int count)
{
  std::vector<Vector3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    directions.push_back(RandomDirection(random));
  }
  return directions;
}

/// (degree + 1)^2 independent normal numbers with deviation decreasing as (l + 1)^-decay.
inline std::vector<double> RandomCoefficients(Random& random, int degree, double decay = 0.0)
{
  std::normal_distribution<double> normal;
  std::vector<double> coefficients;
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      coefficients.push_back(normal(random) * std::pow(l + 1.0, -decay));
    }
  }
  return coefficients;
}

/// An organ-like body: mean radius 20 mm, a few millimetres of smooth relief, centre off the
/// origin.
inline RadialModel RandomOrgan(Random& random, int degree)
{
  std::vector<double> coefficients = RandomCoefficients(random, degree, 2.0);
  for (double& c : coefficients)
  {
    c *= 4.0;
  }
  coefficients[0] = 20.0 * std::sqrt(4.0 * M_PI);
  std::uniform_real_distribution<double> offset(-100.0, 100.0);
  return {degree, coefficients, {offset(random), offset(random), offset(random)}};
}
} // namespace palpate::test
