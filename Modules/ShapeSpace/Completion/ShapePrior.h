#pragma once

#include "RadialModel.h"
#include "Status.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace palpate
{
/// What is known of an organ's shape before it is touched: a normal distribution of the
/// coefficients of ln(radius / mm) about a centre, in the patient's axes. The logarithm makes size
/// a shift of one coefficient and keeps radii positive. Immutable.
class ShapePrior
{
public:
  static constexpr int UsualDegree = 12;
  static constexpr int LargestDegree = 20;
  /// The harmonic of degree 0, sqrt(1 / (4 pi)).
  static constexpr double ConstantHarmonic = 0.28209479177387814;

  /// Smoothness alone: a sphere of this radius (mm) whose logarithm has a standard deviation of
  /// 0.35, and coefficients of degree l with 0.8 / (l (l + 1)) (a penalty of the Laplacian).
  static ShapePrior Smooth(double radius);
  /// Of radial models of a group, each about its own centre, which a fit places at the centroid:
  /// CoefficientDistribution of their logarithms. Models whose radius is not above a twentieth of
  /// their mean radius everywhere have none and get into `omitted`. Fails if fewer than three are
  /// left. Allocates.
  static Status OfGroup(const std::vector<RadialModel>& models, ShapePrior& prior,
                        std::vector<std::size_t>& omitted);
  /// Of numbers, as a file has them. Fails unless they are finite, of a degree from 1 to
  /// LargestDegree, the covariance is positive definite, and the mean radius 0.1 to 1,000 mm.
  static Status Of(Eigen::VectorXd mean, Eigen::MatrixXd covariance, std::size_t cases,
                   ShapePrior& prior);

  /// A sphere of 25 mm by Smooth.
  ShapePrior() : ShapePrior(Smooth(25.0)) {}

  int Degree() const noexcept { return this->HighestDegree; }
  Eigen::Index Size() const noexcept { return this->MeanLogarithm.size(); }
  const Eigen::VectorXd& Mean() const noexcept { return this->MeanLogarithm; }
  const Eigen::MatrixXd& Covariance() const noexcept { return this->LogarithmCovariance; }
  /// Models of the group; 0 of smoothness alone.
  std::size_t Cases() const noexcept { return this->CaseCount; }

private:
  ShapePrior(int degree, Eigen::VectorXd mean, Eigen::MatrixXd covariance, std::size_t cases);

  int HighestDegree;
  Eigen::VectorXd MeanLogarithm;
  Eigen::MatrixXd LogarithmCovariance;
  std::size_t CaseCount;
};

/// The coefficients, up to `degree`, of the logarithm of a model's radius (mm); and the radial
/// model of such coefficients of its own degree. Both by a quadrature that leaves less than 1e-6 of
/// an organ's radius. Allocate.
Eigen::VectorXd LogarithmOf(const RadialModel& model, int degree);
RadialModel RadialModelOf(const Eigen::VectorXd& logarithm, int degree, const Vector3& centerWorld);
} // namespace palpate
