#pragma once

#include "KernelProgress.h"
#include "LinearModel.h"
#include "Status.h"

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace palpate
{
/// The surface whose points the outcomes belong to.
struct SurfaceGraph
{
  std::vector<double> Areas; ///< of each point, mm^2
  std::vector<std::pair<int, int>> Edges;
};

struct PermutationSettings
{
  int Count = 10000;      ///< random permutations, beside the observed order
  std::uint64_t Seed = 1; ///< results depend on it, not on the number of threads
  unsigned Threads = 0;   ///< 0 for as many as the processor has
};

/// Permutation tests of one term at every point of a surface and of the surface as a whole.
struct PermutationTest
{
  /// Signed t of a term with one column, otherwise the root of F.
  Eigen::VectorXd Statistic;
  Eigen::VectorXd P;       ///< of each point by itself
  Eigen::VectorXd FamilyP; ///< corrected for all points: by the largest statistic of the surface
  Eigen::VectorXd
      EnhancedP;       ///< corrected for all points: by the largest value of ClusterEnhancement
  double WholeF = 0.0; ///< explained by residual variance, both integrated over the surface
  double WholeP = 1.0;
};

/// Residuals under the other terms are permuted (Freedman and Lane, J. Bus. Econ. Stat. 1 (1983)
/// 292; Winkler et al., NeuroImage 92 (2014) 381); positive and negative effects compete for one
/// maximum. A p-value is the share of orders, the observed one included, whose statistic is at
/// least as large. `outcomes` has one outcome per point. Fails only if
/// `progress` cancels.
Status TestByPermutation(const EffectSpace& space, const LinearOutcomes& outcomes,
                         const SurfaceGraph& surface, const PermutationSettings& settings,
                         const KernelProgress& progress, PermutationTest& test);
} // namespace palpate
