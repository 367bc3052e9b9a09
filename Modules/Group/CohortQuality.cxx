#include "CohortQuality.h"

#include "FalseDiscovery.h"
#include "LeftOutProbability.h"
#include "StandardizedDisplacement.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int QualityFrequency = 16; // 2,562 points

std::vector<LeftOutDistance> DistancesOf(const ShapeModes& modes, Eigen::Index count)
{
  const Eigen::Index cases = modes.Scores.rows();
  LeftOutSolver solver(modes);
  std::vector<LeftOutDistance> distances;
  for (Eigen::Index row = 0; row < cases; ++row)
  {
    distances.push_back(DistanceFromOthers(solver.Solve(row), count, cases));
  }
  return distances;
}

UnusualCase CompareWithOthers(const LeftOutDistance& distance, double probability,
                              const StandardizedDisplacement& standardized, Eigen::Index row)
{
  UnusualCase one;
  one.Row = static_cast<std::size_t>(row);
  one.Mahalanobis = distance.Mahalanobis;
  one.OutsideMillimeters = distance.Outside;
  one.P = probability;
  const Eigen::VectorXd map = standardized.Of(row);
  Eigen::Index largest = 0;
  map.cwiseAbs().maxCoeff(&largest);
  one.Point = static_cast<std::size_t>(largest);
  one.LargestZ = map[largest];
  return one;
}

void AddDiscovery(std::vector<UnusualCase>& cases)
{
  Eigen::VectorXd p(static_cast<Eigen::Index>(cases.size()));
  std::transform(cases.begin(), cases.end(), p.begin(),
                 [](const UnusualCase& one) { return one.P; });
  const Eigen::VectorXd rates = FalseDiscoveryRates(p);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    cases[i].Discovery = rates[static_cast<Eigen::Index>(i)];
  }
}
} // namespace

CohortQuality FindCohortQuality(const CohortGroup& group, const RandomShapeSettings& random)
{
  const Eigen::Index cases = group.Modes.Scores.rows();
  CohortQuality quality;
  quality.Random = random;
  quality.Model = MeasureShapeModel(group.Modes, random);
  quality.Surface = FindNormalDisplacement(ShapeOf(group, -1, 0.0), QualityFrequency);
  const StandardizedDisplacement standardized(quality.Surface, group.Modes);
  quality.PointDeviations = standardized.Deviations();
  if (cases < 3 || group.Modes.Modes.cols() == 0)
  {
    return quality;
  }
  quality.ModeCount = CountDistanceModes(group.Modes);
  const std::vector<LeftOutDistance> distances = DistancesOf(group.Modes, quality.ModeCount);
  const Eigen::VectorXd probabilities = LeftOutProbabilities(distances);
  for (Eigen::Index row = 0; row < cases; ++row)
  {
    quality.Distances.push_back(CompareWithOthers(distances[static_cast<std::size_t>(row)],
                                                  probabilities[row], standardized, row));
  }
  AddDiscovery(quality.Distances);
  std::stable_sort(quality.Distances.begin(), quality.Distances.end(),
                   [](const UnusualCase& a, const UnusualCase& b)
                   { return a.P != b.P ? a.P < b.P : a.Mahalanobis > b.Mahalanobis; });
  quality.Maps.resize(quality.PointDeviations.size(),
                      std::min<Eigen::Index>(cases, MostUnusualMaps));
  for (Eigen::Index k = 0; k < quality.Maps.cols(); ++k)
  {
    const UnusualCase& one = quality.Distances[static_cast<std::size_t>(k)];
    quality.Maps.col(k) = standardized.Of(static_cast<Eigen::Index>(one.Row));
  }
  return quality;
}
} // namespace palpate
