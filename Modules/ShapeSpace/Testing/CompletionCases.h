#pragma once

#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "ShapeCompletion.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <memory>
#include <vector>

namespace palpate::test
{
/// Radial bodies that differ in size and relief, some of them lopsided to the left and some to the
/// right.
inline std::vector<RadialModel> RandomGroup(Random& random, int count)
{
  std::normal_distribution<double> normal;
  std::vector<RadialModel> models;
  for (int n = 0; n < count; ++n)
  {
    std::vector<double> coefficients = RandomCoefficients(random, 12, 2.5);
    const double size = 22.0 * std::exp(0.15 * normal(random));
    for (double& one : coefficients)
    {
      one *= 0.2 * size;
    }
    coefficients[0] = size / ShapePrior::ConstantHarmonic;
    models.emplace_back(12, coefficients, Vector3::Zero());
  }
  return models;
}

inline std::shared_ptr<const ShapePrior> GroupPrior(std::uint64_t seed)
{
  Random random(seed);
  ShapePrior prior;
  std::vector<std::size_t> omitted;
  const Status status = ShapePrior::OfGroup(RandomGroup(random, 40), prior, omitted);
  return status.IsOk() ? std::make_shared<const ShapePrior>(std::move(prior)) : nullptr;
}

inline std::vector<Vector3> SphereDirections(int frequency)
{
  return IcosahedronDirections(frequency).Directions();
}

/// A surface that a prior draws.
inline LogSurface SampleOf(const ShapePrior& prior, Random& random, const Vector3& center)
{
  std::normal_distribution<double> normal;
  Eigen::VectorXd white(prior.Size());
  for (double& one : white)
  {
    one = normal(random);
  }
  return {prior.Mean() + prior.Covariance().llt().matrixL() * white, center};
}

inline Vector3 PointOf(const LogSurface& surface, const Vector3& direction)
{
  const auto degree = static_cast<int>(std::lround(std::sqrt(surface.Coefficients.size()))) - 1;
  Eigen::VectorXd values(surface.Coefficients.size());
  SphericalHarmonicBasis(degree).Evaluate(direction, values.data());
  return surface.CenterWorld + std::exp(values.dot(surface.Coefficients)) * direction;
}

inline std::vector<SurfaceTouch> TouchesOf(const LogSurface& surface,
                                           const std::vector<Vector3>& directions, double deviation)
{
  std::vector<SurfaceTouch> touches;
  for (const Vector3& direction : directions)
  {
    touches.push_back({PointOf(surface, direction), deviation});
  }
  return touches;
}

/// The inverse of the prior's covariance of coefficients and centre.
inline Eigen::MatrixXd PriorInformation(const ShapePrior& prior)
{
  const Eigen::Index count = prior.Size();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count + 3, count + 3);
  information.topLeftCorner(count, count) = prior.Covariance().inverse();
  information.diagonal().tail<3>().setConstant(
      1.0 / (ShapeCompletion::CenterDeviation * ShapeCompletion::CenterDeviation));
  return information;
}

/// The derivatives of the rows by coefficients and centre, a row each.
inline Eigen::MatrixXd AllSlopes(const TouchEquations& equations)
{
  const Eigen::Index count = equations.ByCoefficients().rows();
  Eigen::MatrixXd slopes(equations.Rows(), count + 3);
  slopes.leftCols(count) = equations.ByCoefficients().transpose();
  slopes.rightCols<3>() = equations.ByCenter().transpose();
  return slopes;
}
} // namespace palpate::test
