#include "ParametricSurfaceMeasures.h"

#include "SphereQuadrature.h"

#include <cmath>

namespace palpate
{
namespace
{
double AreaByQuadrature(const ParametricSphericalSurface& surface, int degree)
{
  const SphereQuadrature sphere(degree);
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const auto sample = surface.Evaluate(sphere.Directions[i]);
    sum += sphere.Weights[i] * ParametricSphericalSurface::AreaVector(sample).norm();
  }
  return sum;
}

// Integrals of x^0, x and x x^T over the body, with x relative to the surface's mean point.
struct ConeMoments
{
  Vector3 Origin;
  double Volume = 0.0;
  double Gross = 0.0; // without cancellation
  Vector3 First = Vector3::Zero();
  Matrix3 Second = Matrix3::Zero();

  explicit ConeMoments(const ParametricSphericalSurface& surface)
      : Origin(Vector3(surface.Coefficients(0)[0], surface.Coefficients(1)[0],
                       surface.Coefficients(2)[0]) /
               std::sqrt(4.0 * M_PI))
  {
    const SphereQuadrature sphere(5 * surface.Degree());
    for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
    {
      const auto sample = surface.Evaluate(sphere.Directions[i]);
      const Vector3 x = sample.Point - this->Origin;
      // The cone from the origin to a piece of surface holds a third of this, and the integrals of
      // x and x x^T over it are a fourth and a fifth times their values at its base.
      const double cone = sphere.Weights[i] * x.dot(ParametricSphericalSurface::AreaVector(sample));
      this->Volume += cone / 3.0;
      this->Gross += std::abs(cone) / 3.0;
      this->First += cone / 4.0 * x;
      this->Second += cone / 5.0 * x * x.transpose();
    }
  }
};
} // namespace

double AreaOf(const ParametricSphericalSurface& surface, double relativeTolerance)
{
  const int largest = 8 * surface.Degree() + 128;
  int degree = 2 * surface.Degree() + 16;
  double area = AreaByQuadrature(surface, degree);
  double change = 0.0;
  do
  {
    degree += degree / 2;
    const double finer = AreaByQuadrature(surface, degree);
    change = std::abs(finer - area);
    area = finer;
  } while (change > relativeTolerance * area && degree < largest);
  return area;
}

Status MeasureBody(const ParametricSphericalSurface& surface, BodyMoments& moments)
{
  const ConeMoments cones(surface);
  constexpr double Rounding = 1e-12;
  if (!(std::abs(cones.Volume) > Rounding * cones.Gross) || !std::isfinite(cones.Second.sum()))
  {
    return Status::Failure("the surface encloses no finite volume, so it has no centroid");
  }
  const Vector3 centroid = cones.First / cones.Volume;
  moments.Volume = std::abs(cones.Volume);
  moments.CentroidWorld = cones.Origin + centroid;
  moments.SecondMoments = (cones.Volume < 0.0 ? -1.0 : 1.0) * cones.Second -
                          moments.Volume * centroid * centroid.transpose();
  SetPrincipalAxes(moments);
  return Status::Success();
}
} // namespace palpate
