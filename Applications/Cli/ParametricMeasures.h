#pragma once

#include "ParametricSphericalSurface.h"

namespace palpate::cli
{
/// Volume and area of a parametric surface.
struct ParametricMeasures
{
  /// Quadrature over the parameter sphere: the volume is exact up to rounding (its integrand
  /// X . (dX x dX) / 3 is a polynomial), the area to quadrature error.
  explicit ParametricMeasures(const ParametricSphericalSurface& surface);

  double Volume = 0.0; ///< mm^3; negative where the surface is parametrised inside out
  double Area = 0.0;   ///< mm^2
};
} // namespace palpate::cli
