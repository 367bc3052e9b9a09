#include "OrganRelation.h"

#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "ModelMeasures.h"
#include "RadialModelFit.h"
#include "ShapePrior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr int KnownFrequency = 20;        // 4,002 points
constexpr double LeastShare = 0.05;       // of the mean radius
constexpr double WallShare = 0.9;         // of the walls' covariance; the rest is its diagonal
constexpr double WallFloor = 0.01;        // mm^2
constexpr double LargestUnlikeness = 5.0; // RMS of the scores, in standard deviations
constexpr double CovarianceFloor = 1e-6;  // mm^2

SurfaceModel ParametricOf(const OrganModel& model)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  return radial != nullptr ? SurfaceModel::FromModel(*radial) : std::get<SurfaceModel>(model);
}

RadialSamples LogSamples(const SurfaceModel& surface, const Vector3& center)
{
  const IcosahedronDirections sphere(KnownFrequency);
  const std::vector<double> angles = sphere.SolidAngles();
  RadialSamples samples;
  for (std::size_t n = 0; n < angles.size(); ++n)
  {
    const SurfaceModel::Sample at = surface.Evaluate(sphere.Directions()[n]);
    const Vector3 arm = at.Point - center;
    const double distance = std::max(arm.norm(), 1e-6);
    samples.Directions.emplace_back(arm / distance);
    samples.Radii.push_back(std::log(distance));
    const double seen = SurfaceModel::AreaVector(at).dot(arm) / std::pow(distance, 3);
    samples.Weights.push_back(std::max(seen, 0.0) * angles[n]);
  }
  return samples;
}

bool IsPositive(const Eigen::MatrixXd& matrix)
{
  return matrix.allFinite() && matrix.llt().info() == Eigen::Success;
}
} // namespace

void OrganRelation::Regress(const Eigen::MatrixXd& asked, const Eigen::MatrixXd& known)
{
  this->Mean = known.colwise().mean();
  const Eigen::MatrixXd rest = known.rowwise() - this->Mean.transpose();
  const double share = 1.0 / static_cast<double>(known.rows() - 1);
  Eigen::MatrixXd own = share * rest.transpose() * rest;
  this->Deviations = own.diagonal().cwiseMax(1e-12).cwiseSqrt();
  for (int degree = 0; degree <= Degree; ++degree)
  {
    auto part = own.diagonal().segment(degree * degree, 2 * degree + 1);
    const double mean = part.mean();
    part.array() += Ridge * mean + 1e-12;
  }
  const Eigen::MatrixXd cross = share * asked.transpose() * rest;
  this->Gain = own.llt().solve(cross.transpose()).transpose();
  this->Covariance = share * asked.transpose() * asked - this->Gain * cross.transpose();
  this->Covariance = (0.5 * (this->Covariance + this->Covariance.transpose())).eval();
  this->Covariance.diagonal().array() += CovarianceFloor;
}

void OrganRelation::TakeWalls(const Eigen::MatrixXd& distances)
{
  this->WallMean = distances.colwise().mean();
  const Eigen::MatrixXd rest = distances.rowwise() - this->WallMean.transpose();
  this->WallCovariance =
      WallShare / static_cast<double>(distances.rows() - 1) * rest.transpose() * rest;
  this->WallCovariance.diagonal() =
      (this->WallCovariance.diagonal() / WallShare).array() + WallFloor;
}

Status OrganRelation::Predict(const LogSurface& known, Eigen::VectorXd& expected) const
{
  const Eigen::VectorXd excess = known.Coefficients.head(ScoreCount) - this->Mean;
  const double unlikeness =
      excess.cwiseQuotient(this->Deviations).norm() / std::sqrt(static_cast<double>(ScoreCount));
  if (!(unlikeness < LargestUnlikeness))
  {
    return Status::Failure("the known organ is " + FixedText(unlikeness, 1) +
                           " standard deviations from those of the prior's group");
  }
  expected = this->Gain * excess;
  expected.tail<3>() += known.CenterWorld + this->Offset;
  return Status::Success();
}

Status OrganRelation::Check(Eigen::Index asked) const
{
  const bool fits = this->Mean.size() == ScoreCount && this->Deviations.size() == ScoreCount &&
                    this->Gain.rows() == asked && this->Gain.cols() == ScoreCount &&
                    this->Covariance.rows() == asked && this->Covariance.cols() == asked &&
                    this->WallMean.size() == WallCount &&
                    this->WallCovariance.rows() == WallCount &&
                    this->WallCovariance.cols() == WallCount;
  if (!fits || this->Name.size() > LongestName)
  {
    return Status::Failure("relates to another organ by numbers of other sizes");
  }
  if (!this->Mean.allFinite() || !this->Gain.allFinite() || !this->Offset.allFinite() ||
      !this->WallMean.allFinite() || !(this->Deviations.minCoeff() > 0.0))
  {
    return Status::Failure("relates to another organ by numbers that are none");
  }
  if (!IsPositive(this->Covariance) || !IsPositive(this->WallCovariance))
  {
    return Status::Failure(
        "relates to another organ by a covariance that is not positive definite");
  }
  return Status::Success();
}

Status FindLogSurface(const OrganModel& model, LogSurface& made)
{
  const SurfaceModel surface = ParametricOf(model);
  BodyMoments body;
  if (Status status = MeasureBody(surface, body); !status.IsOk())
  {
    return status;
  }
  const RadialSamples samples = LogSamples(surface, body.CentroidWorld);
  RadialModelFitOptions options;
  options.Degree = ShapePrior::UsualDegree;
  RadialModelFitResult fit;
  if (Status status = FitRadialModel(samples, options, fit); !status.IsOk())
  {
    return status;
  }
  const double least = *std::min_element(samples.Radii.begin(), samples.Radii.end());
  if (!(std::exp(least - fit.Coefficients.front() * ShapePrior::ConstantHarmonic) > LeastShare))
  {
    return Status::Failure("comes close to its own centroid");
  }
  made.Coefficients = Eigen::Map<const Eigen::VectorXd>(
      fit.Coefficients.data(), static_cast<Eigen::Index>(fit.Coefficients.size()));
  made.CenterWorld = body.CentroidWorld;
  return Status::Success();
}

LogSurfaceDistance::LogSurfaceDistance(LogSurface surface)
    : Surface(std::move(surface)), Equations(ShapePrior::UsualDegree)
{
}

void LogSurfaceDistance::Evaluate(const Eigen::Matrix3Xd& points)
{
  std::vector<SurfaceTouch> touches(static_cast<std::size_t>(points.cols()));
  for (std::size_t n = 0; n < touches.size(); ++n)
  {
    touches[n].PointWorld = points.col(static_cast<Eigen::Index>(n));
  }
  this->Equations.SetTouches(touches);
  this->Equations.Evaluate(this->Surface);
}
} // namespace palpate
