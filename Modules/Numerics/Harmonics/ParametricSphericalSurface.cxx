#include "ParametricSphericalSurface.h"

#include "SphereQuadrature.h"
#include "SphericalHarmonicProjection.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace palpate
{
ParametricSphericalSurface::ParametricSphericalSurface(
    int degree, const std::array<std::vector<double>, 3>& coefficients)
    : Coordinates{SphericalHarmonicModel(degree, coefficients[0], Vector3::Zero()),
                  SphericalHarmonicModel(degree, coefficients[1], Vector3::Zero()),
                  SphericalHarmonicModel(degree, coefficients[2], Vector3::Zero())}
{
}

ParametricSphericalSurface
ParametricSphericalSurface::FromModel(const SphericalHarmonicModel& model)
{
  const int degree = model.Degree() + 1;
  // R(u) u_k times a harmonic is a polynomial of degree 2 (L + 1): the quadrature is exact.
  const auto coordinate = [&](Eigen::Index axis)
  {
    return ProjectOnHarmonics(degree, 2 * degree,
                              [&](const Vector3& u) { return model.PointWorld(u)[axis]; });
  };
  return {degree, {coordinate(0), coordinate(1), coordinate(2)}};
}

Vector3 ParametricSphericalSurface::Point(const Vector3& parameter) const noexcept
{
  return {this->Coordinates[0].Radius(parameter), this->Coordinates[1].Radius(parameter),
          this->Coordinates[2].Radius(parameter)};
}

Vector3 ParametricSphericalSurface::AreaVector(const Vector3& parameter) const noexcept
{
  Eigen::Matrix3d gradients; // row k: surface gradient of coordinate k
  for (int k = 0; k < 3; ++k)
  {
    gradients.row(k) =
        this->Coordinates[static_cast<std::size_t>(k)].Evaluate(parameter).SurfaceGradient;
  }
  const Vector3 first = parameter.unitOrthogonal();
  const Vector3 second = parameter.cross(first);
  return (gradients * first).cross(gradients * second);
}

Vector3 ParametricSphericalSurface::Normal(const Vector3& parameter) const noexcept
{
  const Vector3 normal = this->AreaVector(parameter);
  const double length = normal.norm();
  return length > std::numeric_limits<double>::min() ? Vector3(normal / length) : Vector3::Zero();
}

double ParametricSphericalSurface::Volume() const
{
  const SphereQuadrature sphere(3 * this->Degree() + 2);
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const Vector3& u = sphere.Directions[i];
    sum += sphere.Weights[i] * this->Point(u).dot(this->AreaVector(u));
  }
  return sum / 3.0;
}

double ParametricSphericalSurface::Area() const
{
  const SphereQuadrature sphere(4 * this->Degree() + 16);
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    sum += sphere.Weights[i] * this->AreaVector(sphere.Directions[i]).norm();
  }
  return sum;
}
} // namespace palpate
