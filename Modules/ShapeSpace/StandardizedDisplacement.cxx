#include "StandardizedDisplacement.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double LeastVariance = 1e-12; // mm^2
} // namespace

// Scores of different modes are uncorrelated, so their squares add up.
StandardizedDisplacement::StandardizedDisplacement(const NormalDisplacement& mean,
                                                   const ShapeModes& modes)
    : PerScore(mean.PerCoefficient * modes.Modes), Scores(modes.Scores.transpose()),
      Squares((PerScore.array().square().matrix() * modes.Deviations.cwiseAbs2()).array() *
              static_cast<double>(modes.Scores.rows() - 1))
{
}

Eigen::VectorXd StandardizedDisplacement::Deviations() const
{
  return (this->Squares / static_cast<double>(this->Scores.cols() - 1)).sqrt().matrix();
}

// Without a case at u from the mean of all n, the mean moves by -u / (n - 1) and the squares about
// it fall by u^2 n / (n - 1).
Eigen::VectorXd StandardizedDisplacement::Of(Eigen::Index leftOut) const
{
  if (this->Scores.cols() < 3)
  {
    return Eigen::VectorXd::Zero(this->PerScore.rows());
  }
  const auto cases = static_cast<double>(this->Scores.cols());
  const double factor = cases / (cases - 1.0);
  const Eigen::ArrayXd displacement = (this->PerScore * this->Scores.col(leftOut)).array();
  const Eigen::ArrayXd variances = (this->Squares - factor * displacement.square()) / (cases - 2.0);
  return (factor * displacement / variances.max(LeastVariance).sqrt()).matrix();
}
} // namespace palpate
