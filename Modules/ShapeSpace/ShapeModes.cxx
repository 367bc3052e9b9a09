#include "ShapeModes.h"

#include "ThinSvd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Singular values below this fraction of the data's norm are rounding.
double RoundingOf(const Eigen::MatrixXd& coefficients)
{
  return 8.0 * std::numeric_limits<double>::epsilon() * coefficients.norm();
}
} // namespace

Status FindShapeModes(const Eigen::MatrixXd& coefficients, ShapeModes& result)
{
  const Eigen::Index cases = coefficients.rows();
  if (cases < 2)
  {
    return Status::Failure("the variation of shapes needs at least two cases");
  }
  if (!coefficients.allFinite())
  {
    return Status::Failure("a coefficient is not finite");
  }
  result.Mean = coefficients.colwise().mean().transpose();
  const Eigen::MatrixXd centered = coefficients.rowwise() - result.Mean.transpose();
  const ThinSvd svd(centered);
  const Eigen::VectorXd& values = svd.Values;
  const Eigen::Index count = (values.array() > RoundingOf(coefficients)).count();
  result.Modes = svd.V.leftCols(count);
  result.Deviations = values.head(count) / std::sqrt(static_cast<double>(cases - 1));
  for (Eigen::Index k = 0; k < count; ++k)
  {
    Eigen::Index largest = 0;
    result.Modes.col(k).cwiseAbs().maxCoeff(&largest);
    if (result.Modes(largest, k) < 0.0)
    {
      result.Modes.col(k) = -result.Modes.col(k);
    }
  }
  result.Scores = centered * result.Modes;
  result.Explained = values.head(count).cwiseAbs2() / values.squaredNorm();
  return Status::Success();
}

Eigen::Index CountStableModes(const ShapeModes& modes, Eigen::Index freeDegrees)
{
  constexpr double EnoughVariance = 0.95;
  constexpr Eigen::Index DegreesPerMode = 5;
  const Eigen::Index most =
      std::min(std::max<Eigen::Index>(freeDegrees / DegreesPerMode, 1), modes.Explained.size());
  double explained = 0.0;
  for (Eigen::Index k = 0; k < most; ++k)
  {
    explained += modes.Explained[k];
    if (explained >= EnoughVariance)
    {
      return k + 1;
    }
  }
  return most;
}
} // namespace palpate
