#pragma once

#include <vector>

namespace palpate
{
/// Gauss-Legendre quadrature on [-1, 1]: n nodes integrate polynomials of degree 2n-1 exactly.
/// Nodes by Newton's method on P_n from the asymptotic guess cos(pi (i - 1/4) / (n + 1/2)).
struct GaussLegendre
{
  explicit GaussLegendre(int nodeCount);

  std::vector<double> Nodes;   ///< ascending, in (-1, 1)
  std::vector<double> Weights; ///< positive, their sum is 2
};
} // namespace palpate
