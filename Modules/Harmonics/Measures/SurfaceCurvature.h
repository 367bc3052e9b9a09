#pragma once

#include "RadialModel.h"
#include "SurfaceModel.h"
#include "Vector3.h"

#include <array>

namespace palpate
{
/// Curvature of a surface at one point. It is positive where the surface bends away from the
/// outward normal: a sphere of radius a has mean curvature 1/a.
struct SurfaceCurvature
{
  double Mean;                     ///< half the sum of the principal curvatures, 1/mm
  double Gaussian;                 ///< their product, 1/mm^2
  std::array<double, 2> Principal; ///< the larger first, 1/mm
  /// Unit tangents of the surface in the model's axes, perpendicular to each other, in the order
  /// of Principal. At an umbilic point, where every direction is principal, any such pair.
  std::array<Vector3, 2> Directions;
};

/// Of a radial model x(u) = centre + R(u) u with the normal R u - grad R.
/// Curvature where the unit vector `direction` meets the surface, from the radius and its first two
/// derivatives there (RadialModel::EvaluateSecondOrder). If R < 0 it is that of the
/// surface through centre + R u, still with the normal pointing away from the centre. If R = 0 the
/// surface has no tangent plane, and all results are NaN. The fundamental forms are in README.md.
/// Source: do Carmo, Differential Geometry of Curves and Surfaces (1976), sections 2-5 and 3-3, for
/// x(u) = R u.
SurfaceCurvature CurvatureAt(const Vector3& direction,
                             const RadialModel::SecondOrderSample& sample) noexcept;

/// Of a surface model with the normal X_a x X_b: if the surface is parametrised inside out, a
/// sphere's curvature is negative. Where the surface has no tangent plane, all results are NaN or
/// dominated by rounding.
SurfaceCurvature CurvatureAt(const SurfaceModel::SecondOrderSample& sample) noexcept;
} // namespace palpate
