#include "SphericalHarmonicMeasures.h"

#include "GaussLegendre.h"
#include "LatitudeSynthesis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
using RadialSample = SphericalHarmonicModel::Sample;

// Visits the nodes of a quadrature that is exact for polynomials of this degree: Gauss-Legendre in
// z, equal steps in longitude, as SphereQuadrature, but circle by circle.
template <typename Add>
void ForEachSample(const SphericalHarmonicModel& model, int degree, Add add)
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

double AreaByQuadrature(const SphericalHarmonicModel& model, int degree)
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

// Integrals of x^0, x and x x^T over the body, with x relative to the model's centre.
struct CentralMoments
{
  double Volume = 0.0;
  Vector3 First = Vector3::Zero();
  Eigen::Matrix3d Second = Eigen::Matrix3d::Zero();

  explicit CentralMoments(const SphericalHarmonicModel& model)
  {
    ForEachSample(model, 5 * model.Degree() + 2,
                  [this](const RadialSample& sample, const Vector3& direction, double weight)
                  {
                    const double cube = weight * std::pow(sample.Radius, 3);
                    const Vector3 point = sample.Radius * direction;
                    this->Volume += cube / 3.0;
                    this->First += cube / 4.0 * point;
                    this->Second += cube / 5.0 * point * point.transpose();
                  });
  }
};

} // namespace

double VolumeOf(const SphericalHarmonicModel& model)
{
  double sum = 0.0;
  ForEachSample(model, 3 * model.Degree(),
                [&sum](const RadialSample& sample, const Vector3&, double weight)
                { sum += weight * sample.Radius * sample.Radius * sample.Radius; });
  return sum / 3.0;
}

double AreaOf(const SphericalHarmonicModel& model, double relativeTolerance)
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

Status MeasureBody(const SphericalHarmonicModel& model, BodyMoments& moments)
{
  const CentralMoments central(model);
  if (!(central.Volume > 0.0) || !std::isfinite(central.Second.sum()))
  {
    return Status::Failure("the model encloses no positive, finite volume, so it has no centroid");
  }
  const Vector3 centroid = central.First / central.Volume;
  moments.Volume = central.Volume;
  moments.CentroidWorld = model.CenterWorld() + centroid;
  moments.SecondMoments = central.Second - central.Volume * centroid * centroid.transpose();
  SetPrincipalAxes(moments);
  return Status::Success();
}
} // namespace palpate
