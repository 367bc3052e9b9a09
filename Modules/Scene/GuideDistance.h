#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneProduct.h"
#include "SceneSettings.h"
#include "StructureDistance.h"

#include <map>
#include <memory>

namespace palpate
{
/// How far, and how finely, the distances to a structure are needed by its guides.
struct GuideReach
{
  double Reach = 0.0; ///< mm to either side of the surface, a multiple of 5; 0: no guide
  double Step = 0.0;  ///< mm between nodes: 1/20 to 1/10 of the shortest range
};

/// For all guides by one structure. Coarse, so that small changes need no new distances.
PALPATESCENE_EXPORT GuideReach ReachOfGuides(const SceneSettings& scene, int id);

/// The distances to structures that guide, by their ids.
using GuideDistances = std::map<int, std::shared_ptr<const StructureDistance>>;

/// The signed distances to the closed surface of a structure, made from the product of its source
/// (see ProtectedSurfaceOf), averaged with a Gaussian of one step. Large structures get wider
/// steps, so that there are at most MostGuideNodes; half of them where the reach is above 100 mm,
/// and fewer for a mesh of more than 100,000 triangles, so that the work is bounded. Throws
/// InputError for a structure without triangles and one that is too large for the range of its
/// guide, FilterError and Cancelled.
PALPATESCENE_EXPORT std::shared_ptr<const StructureDistance>
MakeGuideDistance(const SceneStructure& structure, const SceneProduct& source,
                  const GuideReach& reach, const ProgressFunction& progress);

constexpr double MostGuideNodes = 1e6;
} // namespace palpate
