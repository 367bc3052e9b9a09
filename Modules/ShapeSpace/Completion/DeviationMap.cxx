#include "DeviationMap.h"

#include "IcosahedronDirections.h"

#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double CenterVariance =
    ShapeCompletion::CenterDeviation * ShapeCompletion::CenterDeviation;
constexpr double TouchVariance =
    1.0 + TouchEquations::ModelDeviation * TouchEquations::ModelDeviation; // of a next touch, mm^2
} // namespace

DeviationMap::DeviationMap(std::shared_ptr<const ShapePrior> prior, int frequency)
    : Given(std::move(prior)), Turns(this->Given->Degree()), Turned(this->Given->Size(), 3)
{
  const IcosahedronDirections sphere(frequency);
  this->Rays = sphere.Directions();
  this->SolidAngles = sphere.SolidAngles();
  const SphericalHarmonicBasis basis(this->Given->Degree());
  this->Harmonics.resize(this->Given->Size(), static_cast<Eigen::Index>(this->Rays.size()));
  for (std::size_t n = 0; n < this->Rays.size(); ++n)
  {
    basis.Evaluate(this->Rays[n], this->Harmonics.col(static_cast<Eigen::Index>(n)).data());
  }
  this->PriorVariances =
      (this->Given->Covariance() * this->Harmonics).cwiseProduct(this->Harmonics).colwise().sum();
}

// Radii, normals and lengths.
void DeviationMap::Locate(const LogSurface& surface)
{
  this->Radii.noalias() = this->Harmonics.transpose() * surface.Coefficients;
  this->Radii = this->Radii.array().exp();
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    this->Turns.Turn(Vector3::Unit(k), surface.Coefficients.data(), this->Turned.col(k).data());
  }
  this->Normals.noalias() = this->Turned.transpose() * this->Harmonics;
  this->Lengths.resize(this->Radii.size());
  for (std::size_t n = 0; n < this->Rays.size(); ++n)
  {
    const auto at = static_cast<Eigen::Index>(n);
    const Vector3 turn = this->Normals.col(at);
    const Vector3 v = this->Rays[n] + this->Rays[n].cross(turn);
    this->Normals.col(at) = v.normalized();
    this->Lengths[at] = this->Radii[at] / v.norm();
  }
}

const Eigen::VectorXd& DeviationMap::Evaluate(const ShapeCompletion& completion)
{
  this->Locate(completion.Surface());
  this->Known.resize(completion.Rows(), this->Radii.size());
  this->Known.noalias() = completion.Gain().transpose() * this->Harmonics;
  this->Known *= this->Lengths.asDiagonal();
  this->Known.noalias() += completion.CenterGain().transpose() * this->Normals;
  completion.Factor().triangularView<Eigen::Lower>().solveInPlace(this->Known);
  this->Deviations = this->Lengths.cwiseAbs2().cwiseProduct(this->PriorVariances);
  this->Deviations.array() += CenterVariance;
  this->Deviations -= this->Known.colwise().squaredNorm().transpose();
  this->Deviations = (this->Deviations.array().max(0.0) + LeftOut * LeftOut).sqrt();
  return this->Deviations;
}

std::vector<Vector3> DeviationMap::NextTouches(const ShapeCompletion& completion, int count)
{
  this->Evaluate(completion);
  const Eigen::MatrixXd scaled = this->Harmonics * this->Lengths.asDiagonal();
  Eigen::MatrixXd covariance = scaled.transpose() * (this->Given->Covariance() * scaled);
  covariance += CenterVariance * this->Normals.transpose() * this->Normals;
  covariance -= this->Known.transpose() * this->Known;
  Eigen::VectorXd areas(this->Radii.size());
  for (Eigen::Index n = 0; n < areas.size(); ++n)
  {
    areas[n] = this->SolidAngles[static_cast<std::size_t>(n)] * std::pow(this->Radii[n], 3) /
               this->Lengths[n];
  }
  std::vector<Vector3> places;
  for (const Eigen::Index best : ChooseTouches(std::move(covariance), areas, count))
  {
    places.emplace_back(completion.Surface().CenterWorld +
                        this->Radii[best] * this->Rays[static_cast<std::size_t>(best)]);
  }
  return places;
}

std::vector<Eigen::Index> ChooseTouches(Eigen::MatrixXd covariance, const Eigen::VectorXd& areas,
                                        int count)
{
  std::vector<Eigen::Index> places;
  for (int next = 0; next < count; ++next)
  {
    const Eigen::VectorXd gains =
        (covariance.cwiseAbs2() * areas)
            .cwiseQuotient((covariance.diagonal().array() + TouchVariance).matrix());
    Eigen::Index best = 0;
    gains.maxCoeff(&best);
    places.push_back(best);
    const Eigen::VectorXd column = covariance.col(best);
    covariance -= column * column.transpose() / (column[best] + TouchVariance);
  }
  return places;
}
} // namespace palpate
