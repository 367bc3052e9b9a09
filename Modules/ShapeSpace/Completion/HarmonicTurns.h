#pragma once

#include "Vector3.h"

#include <Eigen/Core>

namespace palpate
{
/// How coefficients change when the argument of a function on the sphere turns: with
/// D = u x grad over the unit sphere, the components of D f are functions of the degrees of f, so
/// derivatives of any order are sums of the harmonics themselves, exact at the poles too. The
/// gradient over the sphere is -u x D f. Source: angular momentum's ladder operators, Edmonds,
/// Angular Momentum in Quantum Mechanics (1957), section 2.3, for real harmonics
/// (SphericalHarmonicBasis).
class HarmonicTurns
{
public:
  explicit HarmonicTurns(int degree);

  /// The coefficients of axis . D f, of those of f; both (degree + 1)^2. As a matrix it is
  /// antisymmetric. `turned` must not be `coefficients`. Does not allocate.
  void Turn(const Vector3& axis, const double* coefficients, double* turned) const noexcept;

private:
  int Degree;
  Eigen::VectorXd Ladder; // sqrt((l - m) (l + m + 1)) / 2 for l, m at l (l + 1) / 2 + m
};
} // namespace palpate
