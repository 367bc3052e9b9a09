#pragma once

#include "SphericalHarmonicModel.h"
#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// A closed surface x(u), y(u), z(u) (mm) over the parameter sphere, each coordinate a sum of
/// spherical harmonics: the surface of Brechbuhler, Gerig and Kubler (1995) that SPHARM-PDM
/// writes. Unlike a SphericalHarmonicModel it needs no centre and need not be star-shaped.
class ParametricSphericalSurface
{
public:
  /// Coefficients of the three coordinates, (degree + 1)^2 each, in Palpate's convention (see
  /// SphericalHarmonicBasis).
  ParametricSphericalSurface(int degree, const std::array<std::vector<double>, 3>& coefficients);

  /// The star-shaped surface centre + R(u) u in parametric form: exact, since each coordinate of
  /// R(u) u is a sum of harmonics one degree higher.
  static ParametricSphericalSurface FromModel(const SphericalHarmonicModel& model);

  int Degree() const noexcept { return this->Coordinates[0].Degree(); }
  /// Coefficients of coordinate 0, 1 or 2 (mm).
  const std::vector<double>& Coefficients(int coordinate) const noexcept
  {
    return this->Coordinates[static_cast<std::size_t>(coordinate)].Coefficients();
  }

  /// The surface point (mm) of a unit parameter vector.
  Vector3 Point(const Vector3& parameter) const noexcept;
  /// Unit normal: the cross product of two tangents, oriented like the parameter sphere. Zero where
  /// the surface has no tangent plane.
  Vector3 Normal(const Vector3& parameter) const noexcept;

  /// Enclosed volume (mm^3), negative if the surface is parametrised inside out: a third of the
  /// integral of X . (dX x dX), a polynomial that the quadrature integrates exactly. Allocates.
  double Volume() const;
  /// Surface area (mm^2), by quadrature of degree 4L + 16, since the integrand is not a polynomial.
  /// Allocates.
  double Area() const;

private:
  // Cross product of the tangents along two orthonormal directions of the parameter sphere.
  Vector3 AreaVector(const Vector3& parameter) const noexcept;

  // Each coordinate is a function on the sphere, which the model class evaluates.
  std::array<SphericalHarmonicModel, 3> Coordinates;
};
} // namespace palpate
