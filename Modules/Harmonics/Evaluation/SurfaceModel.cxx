#include "SurfaceModel.h"

#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicProjection.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
using SurfaceCoefficients = std::array<std::vector<double>, 3>;

SurfaceCoefficients Resized(SurfaceCoefficients coefficients, int degree)
{
  for (std::vector<double>& coordinate : coefficients)
  {
    coordinate.resize(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  }
  return coefficients;
}
} // namespace

SurfaceModel::SurfaceModel(int degree, const SurfaceCoefficients& coefficients)
    : Evaluator(degree, Resized(coefficients, degree)), MaximumDegree(degree),
      Values(Resized(coefficients, degree))
{
}

SurfaceModel SurfaceModel::FromModel(const RadialModel& model)
{
  const int degree = model.Degree() + 1;
  // R(u) u_k times a harmonic is a polynomial of degree 2 (L + 1): the quadrature is exact.
  return {degree,
          ProjectPointsOnHarmonics(degree, 2 * degree,
                                   [&model](const Vector3& u) { return model.PointWorld(u); })};
}

Vector3 SurfaceModel::Normal(const Vector3& parameter) const noexcept
{
  const Vector3 normal = AreaVector(this->Evaluate(parameter));
  const double length = normal.norm();
  return length > std::numeric_limits<double>::min() ? Vector3(normal / length) : Vector3::Zero();
}

double SurfaceModel::Volume() const
{
  const SphereQuadrature sphere(3 * this->Degree());
  // Relative to the mean point, since the terms of a body far from the origin would cancel.
  const Vector3 mean =
      Vector3(this->Values[0][0], this->Values[1][0], this->Values[2][0]) / std::sqrt(4.0 * M_PI);
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const Sample sample = this->Evaluate(sphere.Directions[i]);
    sum += sphere.Weights[i] * (sample.Point - mean).dot(AreaVector(sample));
  }
  return sum / 3.0;
}

double SurfaceModel::Area() const
{
  const SphereQuadrature sphere(4 * this->Degree() + 16);
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    sum += sphere.Weights[i] * AreaVector(this->Evaluate(sphere.Directions[i])).norm();
  }
  return sum;
}

std::vector<double> SurfaceModel::PowerSpectrum() const
{
  std::vector<double> power;
  for (int l = 0; l <= this->Degree(); ++l)
  {
    double sum = 0.0;
    for (const std::vector<double>& coordinate : this->Values)
    {
      for (int m = -l; m <= l; ++m)
      {
        const double c = coordinate[SphericalHarmonicBasis::Index(l, m)];
        sum += c * c;
      }
    }
    power.push_back(sum);
  }
  return power;
}

SurfaceModel SurfaceModel::WithDegree(int degree) const
{
  return {degree, this->Values};
}

SurfaceModel SurfaceModel::Transformed(const Matrix3& linear, const Vector3& translation) const
{
  SurfaceCoefficients moved = this->Values;
  for (std::size_t k = 0; k < this->Values[0].size(); ++k)
  {
    const Vector3 c = linear * Vector3(this->Values[0][k], this->Values[1][k], this->Values[2][k]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      moved[axis][k] = c[static_cast<Eigen::Index>(axis)];
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    moved[axis][0] += translation[static_cast<Eigen::Index>(axis)] * std::sqrt(4.0 * M_PI);
  }
  return {this->Degree(), moved};
}

SurfaceModel SurfaceModel::Reparametrized(const Matrix3& orthogonal) const
{
  return {this->Degree(),
          ProjectPointsOnHarmonics(this->Degree(), 2 * this->Degree(),
                                   [&](const Vector3& u) { return this->Point(orthogonal * u); })};
}
} // namespace palpate
