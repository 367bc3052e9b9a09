#include "CoarseMap.h"

#include "MapRefinement.h"
#include "MeshSimplification.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// Simplifications that differ.
constexpr std::array<double, 5> ChangePenalties = {0.1, 0.02, 0.05, 0.3, 1.0};
constexpr int TrialSteps = 300;
// MapDescent's energy of a surface of area 4 pi that is mapped without distortion.
constexpr double LeastEnergy = 16.0 * M_SQRT2 * M_PI;
// Below this share of it, trials agree.
constexpr double SimpleShare = 1.04;
// A map has to be better by more than rounding, or copies of a surface get different ones.
constexpr double BetterShare = 0.998;
} // namespace

bool MapCoarseSurface(const VertexRings& rings, const KernelProgress& progress,
                      std::vector<MappedVertex>& vertices)
{
  double least = std::numeric_limits<double>::infinity();
  std::vector<MappedVertex> best;
  for (std::size_t i = 0; i < ChangePenalties.size() && least > SimpleShare * LeastEnergy; ++i)
  {
    if (progress && !progress(static_cast<double>(i) / ChangePenalties.size()))
    {
      return false;
    }
    VertexRings trial = rings;
    std::vector<MappedVertex> mapped = vertices;
    MeshSimplification simplification;
    SimplificationSettings settings;
    settings.ChangePenalty = ChangePenalties[i];
    Simplify(mapped, settings, {}, trial, simplification);
    MapRefinement refinement(trial, mapped);
    if (!refinement.ReturnAll(simplification, {}))
    {
      continue;
    }
    // A simple shape has one minimum, which sweeps find: a descent would only move its map about.
    const double enough = i == 0 ? SimpleShare * LeastEnergy : 0.0;
    const double energy = refinement.Descend(TrialSteps, enough);
    if (energy < BetterShare * least)
    {
      least = energy;
      best = std::move(mapped);
    }
  }
  if (best.empty())
  {
    return false;
  }
  vertices = std::move(best);
  return true;
}
} // namespace palpate
