#include "LeftOutProbability.h"

#include "ProbabilityDistributions.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double RarestCounted = 0.001;

// What the others' variance exceeds a new case's by, as a factor of F; at most 1.
double FactorByPrediction(const std::vector<LeftOutDistance>& distances)
{
  double found = 0.0;
  double expected = 0.0;
  for (const LeftOutDistance& one : distances)
  {
    const double degrees = one.DenominatorDegrees;
    if (degrees > 2.0) // else the distribution has no mean
    {
      found += std::min(one.F, FisherUpperQuantile(RarestCounted, one.NumeratorDegrees, degrees));
      expected += degrees / (degrees - 2.0);
    }
  }
  return found > 0.0 ? std::min(found / expected, 1.0) : 1.0;
}
} // namespace

Eigen::VectorXd LeftOutProbabilities(const std::vector<LeftOutDistance>& distances)
{
  const double factor = FactorByPrediction(distances);
  Eigen::VectorXd probabilities(static_cast<Eigen::Index>(distances.size()));
  std::transform(distances.begin(), distances.end(), probabilities.begin(),
                 [factor](const LeftOutDistance& one)
                 {
                   return one.DenominatorDegrees > 0.0
                              ? FisherUpper(one.F / factor, one.NumeratorDegrees,
                                            one.DenominatorDegrees)
                              : 1.0;
                 });
  return probabilities;
}
} // namespace palpate
