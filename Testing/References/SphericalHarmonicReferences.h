#pragma once

#include "SphericalHarmonicBasis.h"
#include "Vector3.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace palpate::test
{
enum class ReferenceKind
{
  General,  ///< a direction far from both poles or on the equator
  Pole,     ///< exactly a pole
  NearPole, ///< 1e-3, 1e-8, 1e-15 or 1e-300 rad from one
  Float     ///< components are exact floats; the vector is unit to float rounding only
};

/// One sum of spherical harmonics at one direction, known to 50 digits and rounded once. The values
/// belong to the direction divided by its exact length: the function is constant along rays.
struct SphericalHarmonicReference
{
  int Degree;
  ReferenceKind Kind;
  std::uint64_t Seed; ///< of ReferenceCoefficients
  std::array<double, 3> Direction;
  double Radius;
  std::array<double, 3> Gradient; ///< surface gradient (per rad), tangent to the sphere
  /// Covariant Hessian on the sphere (per rad^2) as a tangent matrix: xx, xy, xz, yy, yz, zz. The
  /// second derivative along the great circle with unit tangent t is t . H t.
  std::array<double, 6> Hessian;
};

/// The table that make_references.py writes.
inline constexpr SphericalHarmonicReference SphericalHarmonicReferences[] = {
#include "SphericalHarmonicReferences.inc"
};

/// The coefficients of a reference, bit for bit those of make_references.py (all are exact floats).
/// Seed 0 is organ-like: radius 20, relief falling as (l + 1)^-2. Seed 3 is the worst for the
/// poles: orders -1, 0 and 1 are 1, so that all degrees add up there. Other seeds are white in [-1,
/// 1).
inline std::vector<double> ReferenceCoefficients(int degree, std::uint64_t seed)
{
  std::uint64_t state = seed;
  std::vector<double> coefficients;
  coefficients.reserve(SphericalHarmonicBasis::CoefficientCount(degree));
  for (int l = 0; l <= degree; ++l)
  {
    const int fall = seed == 0 ? 2 * std::ilogb(l + 1.0) : 0;
    for (int m = -l; m <= l; ++m)
    {
      state = state * 6364136223846793005U + 1442695040888963407U;
      const auto whole = static_cast<std::int64_t>(state >> 43U) - (1 << 20);
      const double white = std::ldexp(static_cast<double>(whole), -20 - fall);
      coefficients.push_back(seed != 3 ? white : std::abs(m) <= 1 ? 1.0 : 0.0);
    }
  }
  if (seed == 0)
  {
    coefficients[0] = 71.0;
  }
  return coefficients;
}

inline double EuclideanNorm(const std::vector<double>& coefficients)
{
  double sum = 0.0;
  for (const double c : coefficients)
  {
    sum += c * c;
  }
  return std::sqrt(sum);
}

/// What errors of a sum with these coefficients are measured against: the largest radius, slope and
/// second derivative along a great circle that any coefficients of this length can reach. With the
/// addition theorem, sum over m of the square of Y_lm, of its slope along a direction and of its
/// second derivative are (2l+1) / (4 pi) times 1, k / 2 and k (3k - 2) / 8, where k = l (l+1).
struct ReferenceScale
{
  double Radius = 0.0;
  double Gradient = 0.0;
  double Hessian = 0.0;

  ReferenceScale(int degree, const std::vector<double>& coefficients)
  {
    for (int l = 0; l <= degree; ++l)
    {
      const double k = static_cast<double>(l) * (l + 1);
      const double share = (2 * l + 1) / (4 * M_PI);
      this->Radius += share;
      this->Gradient += share * k / 2;
      this->Hessian += share * k * (3 * k - 2) / 8;
    }
    const double length = EuclideanNorm(coefficients);
    this->Radius = length * std::sqrt(this->Radius);
    // Degree 0 has no slope: its errors are measured against the radius.
    this->Gradient = degree == 0 ? this->Radius : length * std::sqrt(this->Gradient);
    this->Hessian = degree == 0 ? this->Radius : length * std::sqrt(this->Hessian);
  }
};
} // namespace palpate::test
