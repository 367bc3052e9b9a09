#pragma once

#include "Vector3.h"

#include <cmath>

namespace palpate::test
{
/// R(u) = sum_l sum_m Y_lm(v) Y_lm(u) up to a degree, and its surface gradient, by the addition
/// theorem: sum_l (2l + 1) / (4 pi) P_l(u . v), Legendre's polynomials by their recurrence in long
/// double. One polynomial per degree and no orders, so it shares nothing with the tested code. Both
/// directions are treated as exactly normalised.
struct LegendreSum
{
  LegendreSum(int degree, const Vector3& v, const Vector3& u)
  {
    using Real = long double;
    using Exact = Eigen::Matrix<Real, 3, 1>;
    const Exact to = u.cast<Real>().normalized();
    const Exact from = v.cast<Real>().normalized();
    const Real t = to.dot(from);
    Real before = 1.0L;
    Real current = t;
    Real slopeBefore = 0.0L;
    Real slope = 1.0L;
    Real value = 1.0L;
    Real slopes = 0.0L;
    for (int l = 1; l <= degree; ++l)
    {
      value += (2 * l + 1) * current;
      slopes += (2 * l + 1) * slope;
      const Real next = ((2 * l + 1) * t * current - l * before) / (l + 1);
      // P'_(l+1) = P'_(l-1) + (2 l + 1) P_l.
      const Real slopeNext = slopeBefore + (2 * l + 1) * current;
      before = current;
      current = next;
      slopeBefore = slope;
      slope = slopeNext;
    }
    constexpr Real FourPi = 12.56637061435917295385L;
    this->Value = static_cast<double>(value / FourPi);
    const Exact tangent = from - t * to;
    this->Gradient = (slopes / FourPi * tangent).template cast<double>();
  }

  double Value;
  Vector3 Gradient;
};
} // namespace palpate::test
