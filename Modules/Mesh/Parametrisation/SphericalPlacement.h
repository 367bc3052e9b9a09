#pragma once

#include "Status.h"
#include "Vector3.h"

namespace palpate
{
/// How a parametrisation lies on the sphere, from the degree-1 part of its surface,
///   X(u) ~ c0 + C u  (u a unit vector, X in mm).
/// With real orthonormal harmonics, column j of C is sqrt(3 / 4 pi) times the coefficient vector of
/// order 1, -1, 0 for j = x, y, z. Both functions fail if C is not finite or has s2 + s3 = 0 (see
/// below): then no rotation is better than others.
struct SphericalPlacement
{
  /// Directions turn to Rotation * u; a model's coefficients turn with them.
  Matrix3 Rotation = Matrix3::Identity();
  /// (s2 + s3) / s1 of the singular values of C, s3 negative if det C is: 0 to 2. A perturbation of
  /// C by E turns the rotation by up to 2 |E| / (s2 + s3) rad.
  double Determination = 0.0;
};

/// Rotation is the polar factor of C, the rotation nearest to it: then direction v of the sphere
/// looks to direction v of the frame of X, as far as the shape allows, without choosing axes, their
/// order or signs. `degreeOne` is C in patient LPS, so that the same directions of different
/// patients correspond. A mirrored surface with the mirrored map gets the mirrored placement.
Status PlaceByPolarFactor(const Matrix3& degreeOne, SphericalPlacement& placement);

/// The ellipsoid c0 + C u and the placement by its axes.
struct EllipsoidPlacement
{
  SphericalPlacement Placement;
  Matrix3 Axes = Matrix3::Identity();   ///< columns: unit vectors in the frame of X, right-handed
  Vector3 SemiAxes = Vector3::Zero();   ///< mm, longest first; the last is negative if det C is
  bool IsLongestPairAmbiguous = false;  ///< the first two within 10 %: their directions are noise
  bool IsShortestPairAmbiguous = false; ///< the last two within 10 %
};

/// For surfaces whose file states no orientation: turns the directions so that in the frame of
/// Axes, Axes^T (X - c0) ~ diag(SemiAxes) v. The axes' signs are a convention (the component of
/// largest magnitude of the first two is positive), so that a body turned by pi may get another
/// placement; an ambiguous pair of axes may have any direction in its plane.
Status PlaceByEllipsoid(const Matrix3& degreeOne, EllipsoidPlacement& placement);
} // namespace palpate
