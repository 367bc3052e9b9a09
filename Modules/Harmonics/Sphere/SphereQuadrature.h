#pragma once

#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Product quadrature on the unit sphere: Gauss-Legendre in z, equal steps in longitude. Integrates
/// every polynomial of the given degree (every spherical harmonic up to it) exactly.
struct SphereQuadrature
{
  explicit SphereQuadrature(int degree);

  std::vector<Vector3> Directions; ///< unit vectors
  std::vector<double> Weights;     ///< solid angles; their sum is 4 pi
};
} // namespace palpate
