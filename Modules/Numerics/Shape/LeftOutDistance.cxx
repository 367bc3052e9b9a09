#include "LeftOutDistance.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double DescribedVariance = 0.95;
constexpr Eigen::Index CasesPerMode = 5;
} // namespace

Eigen::Index CountDistanceModes(const ShapeModes& modes)
{
  const Eigen::Index most = std::min(
      std::max<Eigen::Index>((modes.Scores.rows() - 1) / CasesPerMode, 1), modes.Explained.size());
  double explained = 0.0;
  for (Eigen::Index k = 0; k < most; ++k)
  {
    explained += modes.Explained[k];
    if (explained >= DescribedVariance)
    {
      return k + 1;
    }
  }
  return most;
}

LeftOutDistance DistanceFromOthers(const LeftOutModes& others, Eigen::Index count,
                                   Eigen::Index cases)
{
  LeftOutDistance distance;
  const Eigen::Index used = std::min(count, others.Variances.size());
  distance.ModeCount = used;
  distance.Outside = std::sqrt(
      (others.Squares.tail(others.Squares.size() - used).sum() + others.Outside) / (4.0 * M_PI));
  if (used == 0)
  {
    return distance;
  }
  const double squared = others.Squares.head(used).cwiseQuotient(others.Variances.head(used)).sum();
  const auto k = static_cast<double>(used);
  const auto m = static_cast<double>(cases - 1);
  distance.Mahalanobis = std::sqrt(squared);
  distance.NumeratorDegrees = k;
  distance.DenominatorDegrees = m - k;
  distance.F = squared * m / (m + 1.0) * (m - k) / (k * (m - 1.0));
  return distance;
}
} // namespace palpate
