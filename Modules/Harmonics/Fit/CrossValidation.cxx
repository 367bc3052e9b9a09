#include "CrossValidation.h"

#include "ThinSvd.h"

#include <cmath>

namespace palpate
{
using Index = Eigen::Index;

CrossValidation::CrossValidation(const LeastSquaresSolver& solver, double samples)
    : Samples(samples), Unreachable(solver.Unreachable())
{
  const Eigen::MatrixXd triangle = solver.Triangle().UpperFactor();
  const Index size = triangle.cols();
  Eigen::VectorXd scales(size - 1);
  for (int l = 1; static_cast<Index>(l) * l < size; ++l)
  {
    scales.segment(static_cast<Index>(l) * l - 1, 2 * l + 1)
        .setConstant(1.0 / std::sqrt(LeastSquaresSolver::Roughness(l)));
  }
  // The first column of the triangle is nonzero only in its first row, so projecting the constant
  // out of the other columns drops the first row.
  const ThinSvd svd(triangle.bottomRightCorner(size - 1, size - 1) * scales.asDiagonal());
  this->Values = svd.Values;
  const Eigen::Map<const Eigen::VectorXd> right(solver.Projection().data(), size);
  this->Right = svd.U.transpose() * right.tail(size - 1);
}

double CrossValidation::Strength() const
{
  const double high = 2.0 * std::log(this->Values[0]) + 2.0;
  const double low = high - 2.0 * std::log(1e12);
  constexpr int ScanSteps = 60;
  double best = low;
  for (int i = 0; i <= ScanSteps; ++i)
  {
    const double candidate = low + (high - low) * i / ScanSteps;
    if (this->Function(candidate) < this->Function(best))
    {
      best = candidate;
    }
  }
  const double step = (high - low) / ScanSteps;
  return std::exp(this->GoldenSection(best - step, best + step));
}

double CrossValidation::Function(double logStrength) const
{
  const double strength = std::exp(logStrength);
  const Eigen::ArrayXd squares = this->Values.array().square();
  const Eigen::ArrayXd kept = squares / (squares + strength);
  const double residual = ((1.0 - kept) * this->Right.array()).square().sum() + this->Unreachable;
  const double free = this->Samples - 1.0 - kept.sum();
  return residual / (free * free);
}

double CrossValidation::GoldenSection(double low, double high) const
{
  const double ratio = (std::sqrt(5.0) - 1.0) / 2.0;
  while (high - low > 1e-3)
  {
    const double left = high - ratio * (high - low);
    const double right = low + ratio * (high - low);
    if (this->Function(left) < this->Function(right))
    {
      high = right;
    }
    else
    {
      low = left;
    }
  }
  return 0.5 * (low + high);
}
} // namespace palpate
