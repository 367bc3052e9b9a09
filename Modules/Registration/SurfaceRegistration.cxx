#include "SurfaceRegistration.h"

#include "Median.h"
#include "NearestOnMesh.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr double OutlierNoises = 3.0;     // of the noise: distances from which points count less
constexpr double OutlierMedians = 2.5;    // the same of the median distance
constexpr double LeastGain = 1e-9;        // of the cost: smaller ones end it
constexpr double LeastStep = 1e-5;        // mm: shorter ones end it, too
constexpr double LargestDamping = 1e8;    // of the diagonal: no step is left
constexpr double NormalOfMedian = 1.4826; // the normal distribution's deviation over its median

struct Residual
{
  Vector3 Point;
  Vector3 Direction; // away from the surface
  double Distance = 0.0;
};

// Points on a surface, and how far they are from it.
class MovedPoints
{
public:
  MovedPoints(const std::vector<Vector3>& points, const IndexedMesh& fixed,
              const NearestOnMesh& nearest)
      : Moving(points), Fixed(fixed), Nearest(nearest)
  {
  }

  std::vector<Residual> At(const Eigen::Affine3d& map) const
  {
    std::vector<Vector3> places(this->Moving.size());
    std::transform(this->Moving.begin(), this->Moving.end(), places.begin(),
                   [&map](const Vector3& point) { return Vector3(map * point); });
    const std::vector<NearestOnMesh::Result> near = this->Nearest.FindAll(places);
    std::vector<Residual> residuals(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      residuals[i] = {places[i], this->DirectionOf(places[i], near[i]), near[i].Distance};
    }
    return residuals;
  }

private:
  // On the surface itself, the triangle's normal.
  Vector3 DirectionOf(const Vector3& place, const NearestOnMesh::Result& near) const
  {
    constexpr double Rounding = 1e-9; // mm
    if (near.Distance > Rounding)
    {
      return (place - near.Point) / near.Distance;
    }
    return AreaVector(this->Fixed, this->Fixed.Triangles[near.Triangle]).stableNormalized();
  }

  const std::vector<Vector3>& Moving;
  const IndexedMesh& Fixed;
  const NearestOnMesh& Nearest;
};

double MedianOf(const std::vector<Residual>& residuals)
{
  std::vector<double> distances(residuals.size());
  std::transform(residuals.begin(), residuals.end(), distances.begin(),
                 [](const Residual& one) { return one.Distance; });
  return UpperMedian(distances);
}

double RmsOf(const std::vector<Residual>& residuals)
{
  double sum = 0.0;
  for (const Residual& one : residuals)
  {
    sum += one.Distance * one.Distance;
  }
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}

// The weighted equations of a step, and the cost that it lowers: sum d^2 / (1 + d^2 / scale^2).
struct Equations
{
  Equations(const std::vector<Residual>& residuals, const RegistrationStep& step, double scale)
      : Normal(Eigen::MatrixXd::Zero(step.Count(), step.Count())),
        Gradient(Eigen::VectorXd::Zero(step.Count()))
  {
    for (const Residual& one : residuals)
    {
      const Eigen::VectorXd row = step.Derivatives(one.Point, one.Direction);
      const double ratio = one.Distance / scale;
      const double weight = 1.0 / std::pow(1.0 + ratio * ratio, 2);
      this->Normal.noalias() += weight * row * row.transpose();
      this->Gradient += weight * one.Distance * row;
    }
  }
  // Damped; the small constant is for turns without effect, as of a ball.
  Eigen::VectorXd Solve(double damping) const
  {
    constexpr double Flat = 1e-10;
    Eigen::MatrixXd damped = this->Normal;
    damped.diagonal() += damping * this->Normal.diagonal();
    damped.diagonal().array() += Flat * this->Normal.diagonal().maxCoeff();
    return -damped.ldlt().solve(this->Gradient);
  }

  Eigen::MatrixXd Normal;
  Eigen::VectorXd Gradient;
};

double CostOf(const std::vector<Residual>& residuals, double scale)
{
  double cost = 0.0;
  for (const Residual& one : residuals)
  {
    const double square = one.Distance * one.Distance;
    cost += square / (1.0 + square / (scale * scale));
  }
  return cost;
}

RegistrationStep StepAbout(const std::vector<Residual>& residuals, RegistrationKind kind,
                           double& radius)
{
  Vector3 pivot = Vector3::Zero();
  for (const Residual& one : residuals)
  {
    pivot += one.Point / static_cast<double>(residuals.size());
  }
  double squares = 0.0;
  for (const Residual& one : residuals)
  {
    squares += (one.Point - pivot).squaredNorm();
  }
  radius = std::sqrt(squares / static_cast<double>(residuals.size()));
  return {kind, pivot, radius > 0.0 ? radius : 1.0};
}

// The iteration from a start.
class Descent
{
public:
  Descent(const MovedPoints& points, const SurfaceRegistrationSettings& settings,
          const Eigen::Affine3d& start)
      : Points(points), Settings(settings)
  {
    this->Found.Map = start;
    this->Residuals = points.At(start);
  }

  // False if nothing is left to gain.
  bool Step()
  {
    const double scale = this->Scale();
    double radius = 1.0;
    const RegistrationStep step = StepAbout(this->Residuals, this->Settings.Kind, radius);
    const Equations equations(this->Residuals, step, scale);
    const double cost = CostOf(this->Residuals, scale);
    while (this->Damping < LargestDamping)
    {
      const Eigen::VectorXd unknowns = equations.Solve(this->Damping);
      const Eigen::Affine3d map = step.MapOf(unknowns) * this->Found.Map;
      std::vector<Residual> residuals = this->Points.At(map);
      const double gain = cost - CostOf(residuals, scale);
      if (gain > 0.0)
      {
        this->Found.Map = map;
        this->Residuals = std::move(residuals);
        this->Damping = std::max(this->Damping / 10.0, 1e-9);
        return gain > LeastGain * cost && unknowns.norm() > LeastStep;
      }
      this->Damping *= 10.0;
    }
    return false;
  }

  SurfaceRegistration Finish(int steps, bool hasConverged)
  {
    this->Found.Steps = steps;
    this->Found.HasConverged = hasConverged;
    this->Found.Rms = RmsOf(this->Residuals);
    this->Found.Median = MedianOf(this->Residuals);
    if (this->Settings.Kind != RegistrationKind::Affine)
    {
      double radius = 1.0;
      const RegistrationStep step = StepAbout(this->Residuals, this->Settings.Kind, radius);
      const double noise =
          this->Settings.Noise > 0.0 ? this->Settings.Noise : NormalOfMedian * this->Found.Median;
      this->Found.Error = PredictedPoseError::Of(
          Equations(this->Residuals, step, this->Scale()).Normal, radius, noise);
    }
    return this->Found;
  }

private:
  double Scale() const
  {
    constexpr double Least = 1e-12; // mm, of points that lie on the surface
    return std::max(
        {OutlierNoises * this->Settings.Noise, OutlierMedians * MedianOf(this->Residuals), Least});
  }

  const MovedPoints& Points;
  const SurfaceRegistrationSettings& Settings;
  SurfaceRegistration Found;
  std::vector<Residual> Residuals;
  double Damping = 1e-4;
};
} // namespace

Status RegisterToSurface(const std::vector<Vector3>& points, const IndexedMesh& fixed,
                         const Eigen::Affine3d& start, const SurfaceRegistrationSettings& settings,
                         const KernelProgress& progress, SurfaceRegistration& made)
{
  const RegistrationStep any(settings.Kind, Vector3::Zero(), 1.0);
  if (points.size() < static_cast<std::size_t>(any.Count()))
  {
    return Status::Failure("needs at least " + std::to_string(any.Count()) + " points, has " +
                           std::to_string(points.size()));
  }
  const bool isFinite = std::all_of(points.begin(), points.end(),
                                    [](const Vector3& point) { return point.allFinite(); });
  if (!isFinite || !start.matrix().allFinite())
  {
    return Status::Failure("has points that are not finite");
  }
  NearestOnMesh nearest;
  if (Status status = NearestOnMesh::Make(fixed, nearest); !status.IsOk())
  {
    return status;
  }
  const MovedPoints moved(points, fixed, nearest);
  Descent descent(moved, settings, start);
  int steps = 0;
  bool goesOn = true;
  while (goesOn && steps < settings.MostSteps)
  {
    if (progress && !progress(static_cast<double>(steps) / settings.MostSteps))
    {
      return Status::Failure("cancelled");
    }
    goesOn = descent.Step();
    ++steps;
  }
  made = descent.Finish(steps, !goesOn);
  return Status::Success();
}
} // namespace palpate
