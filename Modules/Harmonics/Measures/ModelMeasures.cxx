#include "ModelMeasures.h"

#include "GaussLegendre.h"
#include "LatitudeSynthesis.h"
#include "SphereQuadrature.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
using RadialSample = RadialModel::Sample;

// Visits the nodes of a quadrature that is exact for polynomials of this degree: Gauss-Legendre in
// z, equal steps in longitude, as SphereQuadrature, but circle by circle.
template <typename Add>
void ForEachSample(const RadialModel& model, int degree, Add add)
{
  const GaussLegendre latitude(degree / 2 + 1);
  const int longitudes = degree + 1;
  LatitudeSynthesis circle(model, longitudes);
  for (std::size_t i = 0; i < latitude.Nodes.size(); ++i)
  {
    const double z = latitude.Nodes[i];
    const double weight = latitude.Weights[i] * 2.0 * M_PI / longitudes;
    const std::vector<RadialSample>& samples = circle.Evaluate(z);
    for (std::size_t j = 0; j < samples.size(); ++j)
    {
      add(samples[j], circle.Direction(z, j), weight);
    }
  }
}

double AreaByQuadrature(const RadialModel& model, int degree)
{
  double sum = 0.0;
  ForEachSample(model, degree,
                [&sum](const RadialSample& sample, const Vector3&, double weight)
                {
                  sum += weight * std::abs(sample.Radius) *
                         std::hypot(sample.Radius, sample.SurfaceGradient.norm());
                });
  return sum;
}

double AreaByQuadrature(const SurfaceModel& surface, int degree)
{
  const SphereQuadrature sphere(degree);
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const auto sample = surface.Evaluate(sphere.Directions[i]);
    sum += sphere.Weights[i] * SurfaceModel::AreaVector(sample).norm();
  }
  return sum;
}

template <typename Model>
double ConvergedArea(const Model& model, double relativeTolerance)
{
  const int largest = 8 * model.Degree() + 128;
  int degree = 2 * model.Degree() + 16;
  double area = AreaByQuadrature(model, degree);
  double change = 0.0;
  do
  {
    degree += degree / 2;
    const double finer = AreaByQuadrature(model, degree);
    change = std::abs(finer - area);
    area = finer;
  } while (change > relativeTolerance * area && degree < largest);
  return area;
}

// Integrals of x^0, x and x x^T over the cones from an origin to pieces of the surface, with x
// relative to the origin.
struct ConeMoments
{
  Vector3 Origin;
  double Volume = 0.0;
  double Gross = 0.0; // without cancellation
  Vector3 First = Vector3::Zero();
  Matrix3 Second = Matrix3::Zero();

  explicit ConeMoments(const RadialModel& model) : Origin(model.CenterWorld())
  {
    ForEachSample(model, 5 * model.Degree() + 2,
                  [this](const RadialSample& sample, const Vector3& direction, double weight)
                  { this->Add(sample.Radius * direction, weight * std::pow(sample.Radius, 3)); });
  }

  explicit ConeMoments(const SurfaceModel& surface)
      : Origin(Vector3(surface.Coefficients(0)[0], surface.Coefficients(1)[0],
                       surface.Coefficients(2)[0]) /
               std::sqrt(4.0 * M_PI)) // the surface's mean point
  {
    const SphereQuadrature sphere(5 * surface.Degree());
    for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
    {
      const auto sample = surface.Evaluate(sphere.Directions[i]);
      const Vector3 x = sample.Point - this->Origin;
      this->Add(x, sphere.Weights[i] * x.dot(SurfaceModel::AreaVector(sample)));
    }
  }

  // A cone holds a third of `cone`, and the integrals of x and x x^T over it are a fourth and a
  // fifth times their values at its base.
  void Add(const Vector3& x, double cone)
  {
    this->Volume += cone / 3.0;
    this->Gross += std::abs(cone) / 3.0;
    this->First += cone / 4.0 * x;
    this->Second += cone / 5.0 * x * x.transpose();
  }

  bool IsFinite() const { return std::isfinite(this->Second.sum()); }
};

void SetPrincipalAxes(BodyMoments& moments)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.SecondMoments);
  for (int k = 0; k < 2; ++k)
  {
    Vector3 axis = solver.eigenvectors().col(2 - k);
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    moments.PrincipalAxes.col(k) = axis[largest] < 0.0 ? Vector3(-axis) : axis;
  }
  moments.PrincipalAxes.col(2) = moments.PrincipalAxes.col(0).cross(moments.PrincipalAxes.col(1));
  for (int k = 0; k < 3; ++k)
  {
    // A flat body's smallest moment may be slightly negative by rounding.
    const double moment = std::max(solver.eigenvalues()[2 - k], 0.0);
    moments.SemiAxes[k] = std::sqrt(5.0 * moment / moments.Volume);
  }
}

BodyMoments MomentsOf(const ConeMoments& cones)
{
  const Vector3 centroid = cones.First / cones.Volume;
  BodyMoments moments;
  moments.Volume = std::abs(cones.Volume);
  moments.CentroidWorld = cones.Origin + centroid;
  moments.SecondMoments = (cones.Volume < 0.0 ? -1.0 : 1.0) * cones.Second -
                          moments.Volume * centroid * centroid.transpose();
  SetPrincipalAxes(moments);
  return moments;
}
} // namespace

double VolumeOf(const RadialModel& model)
{
  double sum = 0.0;
  ForEachSample(model, 3 * model.Degree(),
                [&sum](const RadialSample& sample, const Vector3&, double weight)
                { sum += weight * sample.Radius * sample.Radius * sample.Radius; });
  return sum / 3.0;
}

double AreaOf(const RadialModel& model, double relativeTolerance)
{
  return ConvergedArea(model, relativeTolerance);
}

double AreaOf(const SurfaceModel& surface, double relativeTolerance)
{
  return ConvergedArea(surface, relativeTolerance);
}

Status MeasureBody(const RadialModel& model, BodyMoments& moments)
{
  const ConeMoments cones(model);
  if (!(cones.Volume > 0.0) || !cones.IsFinite())
  {
    return Status::Failure("the model encloses no positive, finite volume, so it has no centroid");
  }
  moments = MomentsOf(cones);
  return Status::Success();
}

Status MeasureBody(const SurfaceModel& surface, BodyMoments& moments)
{
  const ConeMoments cones(surface);
  constexpr double Rounding = 1e-12;
  if (!(std::abs(cones.Volume) > Rounding * cones.Gross) || !cones.IsFinite())
  {
    return Status::Failure("the surface encloses no finite volume, so it has no centroid");
  }
  moments = MomentsOf(cones);
  return Status::Success();
}
} // namespace palpate
