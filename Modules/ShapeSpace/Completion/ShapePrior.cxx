#include "ShapePrior.h"

#include "CoefficientDistribution.h"
#include "IcosahedronDirections.h"
#include "SphericalHarmonicConventions.h"
#include "SphericalHarmonicProjection.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t LeastCases = 3;
constexpr double LogSizeDeviation = 0.35;
constexpr double Roughness = 0.8;
constexpr double LeastRadiusShare = 0.05; // of the mean radius
constexpr double SmallestRadius = 0.1;    // mm
constexpr double LargestRadius = 1000.0;  // mm
constexpr int ProjectionDegree = 60;      // of the quadrature

bool HasLogarithm(const RadialModel& model)
{
  const std::vector<Vector3> directions = IcosahedronDirections(20).Directions();
  std::vector<double> radii(directions.size());
  model.RadiusBatch(directions.data(), directions.size(), radii.data());
  const double least =
      LeastRadiusShare * ShapePrior::ConstantHarmonic * model.Coefficients().front();
  return std::all_of(radii.begin(), radii.end(),
                     [least](double radius)
                     { return std::isfinite(radius) && radius > std::max(least, 0.0); });
}
} // namespace

ShapePrior::ShapePrior(int degree, Eigen::VectorXd mean, Eigen::MatrixXd covariance,
                       std::size_t cases)
    : HighestDegree(degree), MeanLogarithm(std::move(mean)),
      LogarithmCovariance(std::move(covariance)), CaseCount(cases)
{
}

ShapePrior ShapePrior::Smooth(double radius)
{
  constexpr Eigen::Index Count = (UsualDegree + 1) * (UsualDegree + 1);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(Count);
  mean[0] = std::log(radius) / ConstantHarmonic;
  Eigen::VectorXd deviations(Count);
  deviations[0] = LogSizeDeviation / ConstantHarmonic;
  for (int degree = 1; degree <= UsualDegree; ++degree)
  {
    deviations.segment(degree * degree, 2 * degree + 1)
        .setConstant(Roughness / (degree * (degree + 1)));
  }
  return {UsualDegree, std::move(mean), deviations.cwiseAbs2().asDiagonal(), 0};
}

Status ShapePrior::OfGroup(const std::vector<RadialModel>& models, ShapePrior& prior,
                           std::vector<std::size_t>& omitted)
{
  constexpr Eigen::Index Count = (UsualDegree + 1) * (UsualDegree + 1);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(models.size()), Count);
  Eigen::Index count = 0;
  omitted.clear();
  for (std::size_t n = 0; n < models.size(); ++n)
  {
    if (HasLogarithm(models[n]))
    {
      rows.row(count++) = LogarithmOf(models[n], UsualDegree);
    }
    else
    {
      omitted.push_back(n);
    }
  }
  if (count < static_cast<Eigen::Index>(LeastCases))
  {
    return Status::Failure("a prior needs at least " + std::to_string(LeastCases) +
                           " radial models, but there are " + std::to_string(count));
  }
  rows.conservativeResize(count, Eigen::NoChange);
  CoefficientDistribution group(rows);
  return Of(std::move(group.Mean), std::move(group.Covariance), static_cast<std::size_t>(count),
            prior);
}

Status ShapePrior::Of(Eigen::VectorXd mean, Eigen::MatrixXd covariance, std::size_t cases,
                      ShapePrior& prior)
{
  const int degree = DegreeOfCount(static_cast<std::size_t>(mean.size()));
  const Eigen::Index count = mean.size();
  if (degree < 1 || degree > LargestDegree ||
      count != static_cast<Eigen::Index>(degree + 1) * (degree + 1) || covariance.rows() != count ||
      covariance.cols() != count)
  {
    return Status::Failure("has numbers of no degree from 1 to " + std::to_string(LargestDegree));
  }
  const double radius = std::exp(mean[0] * ConstantHarmonic);
  if (!mean.allFinite() || !(radius > SmallestRadius) || !(radius < LargestRadius))
  {
    return Status::Failure("has a mean radius outside of 0.1 to 1,000 mm");
  }
  if (!covariance.allFinite() || covariance.llt().info() != Eigen::Success)
  {
    return Status::Failure("has a covariance that is not positive definite");
  }
  prior = ShapePrior(degree, std::move(mean), std::move(covariance), cases);
  return Status::Success();
}

Eigen::VectorXd LogarithmOf(const RadialModel& model, int degree)
{
  const std::vector<double> found = ProjectOnHarmonics(
      degree, ProjectionDegree, [&model](const Vector3& u) { return std::log(model.Radius(u)); });
  return Eigen::Map<const Eigen::VectorXd>(found.data(), static_cast<Eigen::Index>(found.size()));
}

RadialModel RadialModelOf(const Eigen::VectorXd& logarithm, int degree, const Vector3& centerWorld)
{
  const RadialModel exponent(DegreeOfCount(static_cast<std::size_t>(logarithm.size())),
                             {logarithm.begin(), logarithm.end()}, Vector3::Zero());
  return {degree,
          ProjectOnHarmonics(degree, ProjectionDegree,
                             [&exponent](const Vector3& u)
                             { return std::exp(exponent.Radius(u)); }),
          centerWorld};
}
} // namespace palpate
