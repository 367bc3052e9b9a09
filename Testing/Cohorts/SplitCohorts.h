#pragma once

#include "CohortGroup.h"
#include "NormalDisplacement.h"

#include <cstdint>
#include <random>
#include <vector>

namespace palpate::test
{
/// p-values of a simulated study, one of each kind of test.
struct SplitResult
{
  double Scores;   ///< Pillai, parametric
  double Surface;  ///< of the whole surface, by permutation
  double Maximum;  ///< least p of all points, corrected by the largest statistic
  double Enhanced; ///< the same by cluster enhancement
  double Ideal;    ///< parametric t of the mean displacement where the effect is known to be
  double Point;    ///< by permutation, of one random point: uniform under the null hypothesis
};

struct SplitSettings
{
  int PerGroup = 30;
  int Permutations = 499;
  double Bump = 0.0;    ///< mm, added to one group
  double Extent = 20.0; ///< of the bump, mm
};

/// Studies of two groups of real shapes, drawn at random, so that the null hypothesis is true by
/// construction whatever the shapes' distribution; the volume is a covariate. With a bump, cos^2 of
/// the distance from a random point of the mean, in the models' own degree, the alternative is
/// true.
class SplitCohorts
{
public:
  SplitCohorts(CohortGroup group, std::uint64_t seed);

  SplitResult Next(const SplitSettings& settings);

private:
  Eigen::VectorXd BumpCoefficients(const SplitSettings& settings, std::size_t center);

  CohortGroup Group;
  NormalDisplacement Mean;
  Eigen::MatrixXd Coefficients;
  std::mt19937_64 Random;
};
} // namespace palpate::test
