#include "ShapeAlignment.h"

#include "ModelMeasures.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicProjection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <utility>

namespace palpate
{
namespace
{
// Third moments along the principal axes over the second ones to the power 3/2; `thirds` are the
// integrals of the cubes over the body.
Vector3 SkewnessOf(const Vector3& thirds, const BodyMoments& body)
{
  const Vector3 variance =
      (body.PrincipalAxes.transpose() * body.SecondMoments * body.PrincipalAxes).diagonal() /
      body.Volume;
  return (thirds / body.Volume).cwiseQuotient(variance.cwiseMax(1e-300).array().pow(1.5).matrix());
}

// Along an axis a point is r p - q, so the integral over a ray is a polynomial of degree 6 in its
// radius.
Vector3 Skewness(const RadialModel& model, const BodyMoments& body)
{
  const SphereQuadrature sphere(6 * model.Degree() + 3);
  const Vector3 q = body.PrincipalAxes.transpose() * (body.CentroidWorld - model.CenterWorld());
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < sphere.Directions.size(); ++i)
  {
    const double r = model.Radius(sphere.Directions[i]);
    const Vector3 p = body.PrincipalAxes.transpose() * sphere.Directions[i];
    for (int k = 0; k < 3; ++k)
    {
      const double inner = r * (r * (r * p[k] / 6.0 - 0.6 * q[k]) * p[k] + 0.75 * q[k] * q[k]);
      sum[k] += sphere.Weights[i] * r * r * r * (inner * p[k] - q[k] * q[k] * q[k] / 3.0);
    }
  }
  return SkewnessOf(sum, body);
}

// By the divergence theorem: div (x x_k^3) = 6 x_k^3.
Vector3 Skewness(const SurfaceModel& surface, const BodyMoments& body)
{
  const SphereQuadrature sphere(6 * surface.Degree());
  std::vector<SurfaceModel::Sample> samples(sphere.Directions.size());
  surface.EvaluateBatch(sphere.Directions.data(), samples.size(), samples.data());
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vector3 point = body.PrincipalAxes.transpose() * (samples[i].Point - body.CentroidWorld);
    const Vector3 area = body.PrincipalAxes.transpose() * SurfaceModel::AreaVector(samples[i]);
    sum += sphere.Weights[i] / 6.0 * point.dot(area) * point.array().cube().matrix();
  }
  return SkewnessOf(surface.Volume() < 0.0 ? Vector3(-sum) : sum, body);
}

template <typename Model>
Matrix3 SignedAxes(const Model& model, const BodyMoments& body)
{
  const Vector3 skewness = Skewness(model, body);
  Eigen::Index least = 0;
  skewness.cwiseAbs().minCoeff(&least);
  Matrix3 axes = body.PrincipalAxes;
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    if (k != least && skewness[k] < 0.0)
    {
      axes.col(k) = -axes.col(k);
    }
  }
  if (axes.determinant() < 0.0)
  {
    axes.col(least) = -axes.col(least);
  }
  return axes;
}
} // namespace

Status AlignShape(const RadialModel& model, AlignmentAxes axes, RadialModel& aligned)
{
  BodyMoments body;
  if (Status status = MeasureBody(model, body); !status.IsOk())
  {
    return status;
  }
  const int degree = model.Degree();
  if (axes != AlignmentAxes::Ellipsoid)
  {
    aligned = {degree, model.Coefficients(), Vector3::Zero()};
    return Status::Success();
  }
  const Matrix3 turned = SignedAxes(model, body);
  const auto radius = [&](const Vector3& u) { return model.Radius(turned * u); };
  aligned = {degree, ProjectOnHarmonics(degree, 2 * degree, radius), Vector3::Zero()};
  return Status::Success();
}

Status AlignShape(const SurfaceModel& surface, AlignmentAxes axes, SurfaceModel& aligned)
{
  BodyMoments body;
  Status status = MeasureBody(surface, body);
  if (status.IsOk())
  {
    aligned = surface.Transformed(Matrix3::Identity(), -body.CentroidWorld);
    if (axes == AlignmentAxes::Ellipsoid)
    {
      const Matrix3 turned = SignedAxes(surface, body);
      aligned = aligned.Transformed(turned.transpose(), Vector3::Zero()).Reparametrized(turned);
    }
  }
  return status;
}

Status AlignShape(const OrganModel& shape, AlignmentAxes axes, OrganModel& aligned)
{
  return std::visit(
      [&](const auto& one)
      {
        auto moved = one;
        Status status = AlignShape(one, axes, moved);
        aligned = std::move(moved);
        return status;
      },
      shape);
}
} // namespace palpate
