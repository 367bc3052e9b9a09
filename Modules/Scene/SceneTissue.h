#pragma once

#include "PalpateSceneModule.h"
#include "SceneEffect.h"
#include "SceneSettings.h"
#include "SofteningSettings.h"

#include <string>
#include <vector>

namespace palpate
{
/// Keys of structures that yield, in files.
struct TissueKey
{
  static constexpr const char* Modulus = "modulus_kpa";
  static constexpr const char* PoissonRatio = "poisson_ratio";
  static constexpr const char* Support = "support_kpa_per_mm";
  static constexpr const char* FreeSide = "free_side";
  static constexpr const char* FreeDegrees = "free_degrees";
  static constexpr const char* Exaggeration = "exaggeration";
  static constexpr const char* Elements = "elements_across";
  static constexpr const char* ComplianceDegree = "compliance_degree";
  static constexpr const char* MapDegree = "map_degree"; ///< that is felt; pictures have all
  static constexpr const char* Elastography = "elastography_image";
  static constexpr const char* Inclusion = "inclusion_kpa";    ///< of another structure, a label
  static constexpr const char* Neighbour = "holds_kpa_per_mm"; ///< the same
};

/// The numbers of a structure that yields; 0 for the default of SofteningSettings.
PALPATESCENE_EXPORT std::vector<SceneNumber> TissueNumbers();

/// The numbers of labels that are inclusions of structures that yield, or hold them.
PALPATESCENE_EXPORT std::vector<SceneNumber> SurroundingNumbers();

/// The inclusions of a structure that yields, in the order of the scene: other labels with a
/// modulus (TissueKey::Inclusion), displayed and touched or not. For TissueKey::Neighbour what
/// holds it.
PALPATESCENE_EXPORT std::vector<const SceneStructure*>
SurroundingsOf(const SceneSettings& scene, const SceneStructure& structure, const char* key);

/// By the structure's numbers, without images.
PALPATESCENE_EXPORT SofteningSettings SofteningSettingsOf(const SceneStructure& structure);
} // namespace palpate
