#pragma once

#include "SphericalHarmonicBasis.h"
#include "Vector3.h"

#include <Eigen/Core>

namespace palpate
{
/// A unit force spread as in Hertz' contact, 3/(2 pi a^2) sqrt(1 - (rho/a)^2), on a disc in the
/// plane that touches a surface (Johnson, Contact Mechanics, 1985, chapter 4).
struct HertzPatch
{
  Vector3 Point;  ///< centre of the disc, relative to the organ's centre, mm
  Vector3 Normal; ///< unit, outward
  double Radius;  ///< a, mm
  /// Mean curvature of the surface, positive where it is convex, 1/mm: the disc is bent to a sphere
  /// of this curvature, along the normal.
  double Curvature;

  /// Its coefficients per solid angle in the basis' harmonics, Size() values (1/sr): points of the
  /// bent disc count for their directions from the organ's centre.
  void Project(const SphericalHarmonicBasis& basis, double* coefficients) const;

  /// Part of the force that waves of the wave number k carry, for x = k a: 3 (sin x - x cos x)/x^3.
  static double Spectrum(double x) noexcept;
};
} // namespace palpate
