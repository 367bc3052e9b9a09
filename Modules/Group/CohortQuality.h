#pragma once

#include "CohortGroup.h"
#include "NormalDisplacement.h"
#include "PalpateGroupModule.h"
#include "ShapeModelQuality.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// How unusual a case is in its group; its own shape is left out of what it is compared with.
struct UnusualCase
{
  std::size_t Row = 0;      ///< of the group
  double Mahalanobis = 0.0; ///< see LeftOutDistance
  double P = 1.0;           ///< see LeftOutProbabilities
  double Discovery = 1.0;   ///< the smallest false-discovery rate among the cases
  double OutsideMillimeters = 0.0;
  ///@{ Where on the mean its normal displacement has the largest size in the others' deviations.
  double LargestZ = 0.0; ///< with its sign: positive outside
  std::size_t Point = 0;
  ///@}
};

/// How good a group's linear model is, and which of its cases it does not expect.
struct CohortQuality
{
  ShapeModelQuality Model;
  RandomShapeSettings Random;
  Eigen::Index ModeCount = 0;         ///< of the distances
  NormalDisplacement Surface;         ///< of the group's mean
  Eigen::VectorXd PointDeviations;    ///< of normal displacements, mm
  std::vector<UnusualCase> Distances; ///< the most unusual first; none for fewer than three cases
  /// Points x the first cases of Distances: see StandardizedDisplacement.
  Eigen::MatrixXd Maps;
};

/// The most cases with a map.
constexpr int MostUnusualMaps = 24;

/// At the 2,562 points of the effects' maps.
PALPATEGROUP_EXPORT CohortQuality FindCohortQuality(const CohortGroup& group,
                                                    const RandomShapeSettings& random);
} // namespace palpate
