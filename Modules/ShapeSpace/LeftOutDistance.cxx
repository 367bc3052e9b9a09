#include "LeftOutDistance.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
Eigen::Index CountDistanceModes(const ShapeModes& modes)
{
  return CountStableModes(modes, modes.Scores.rows() - 1);
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
