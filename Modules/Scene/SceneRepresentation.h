#pragma once

#include "PalpateSceneModule.h"
#include "SceneEffect.h"
#include "SceneSettings.h"

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace palpate
{
class StructurePlan;

/// Everything that decides how fast and how accurately a structure is touched.
struct ContactSetting
{
  SceneStructure Structure;
  int ToolPoints = 26; ///< of the tool's shell in a field; 0: by voxel size and radius
};

/// A representation of structures for touch. Functions that are empty do not apply.
struct SceneRepresentation
{
  std::string Name;  ///< in files and options: "sub-voxel"
  std::string Label; ///< in the window
  std::vector<SceneSource> Sources;
  bool CanBeDrilled = false;
  /// What SceneAppearance::Automatic displays of a label, unless drilled.
  SceneAppearance Appearance = SceneAppearance::Surface;
  std::vector<SceneNumber> Numbers; ///< of a structure, in addition to its members
  std::string ImageKey;             ///< in files; empty if it takes no image
  std::string ImageLabel;
  /// Adds the contact and its inputs to the plan.
  std::function<void(StructurePlan& plan)> PlanContact;
  /// Adds the display of a label that is not touched; if empty, its surface.
  std::function<void(StructurePlan& plan)> PlanDisplay;
  /// "harmonics of degree 12, nearest point".
  std::function<std::string(const ContactSetting& setting)> Describe;
  /// Short identifier, stable across versions: "harmonics/12/nearest".
  std::function<std::string(const ContactSetting& setting)> KeyOf;
  /// The settings whose speed and accuracy are worth comparing, beginning with `standard`, which
  /// has this representation. `highestDegree`: the highest that the voxels of a label support; of a
  /// model that yields by its file, the degree of its maps, otherwise 0.
  std::function<std::vector<ContactSetting>(const ContactSetting& standard,
                                            const TouchToolSettings& tool, int highestDegree)>
      Vary;

  PALPATESCENE_EXPORT bool Takes(SceneSource source) const;
};

/// Automatic, harmonics, facets, sub-voxel, model-or-field, elastic, then those added by
/// AddSceneRepresentation.
PALPATESCENE_EXPORT const std::deque<SceneRepresentation>& SceneRepresentations();

/// Adds a representation for the whole program, or replaces the one of its name, before the first
/// scene is read or shown.
PALPATESCENE_EXPORT void AddSceneRepresentation(SceneRepresentation representation);

/// Throws InputError if there is no representation of that name.
PALPATESCENE_EXPORT const SceneRepresentation& RepresentationOf(const SceneStructure& structure);

/// The settings without duplicates, in their order.
PALPATESCENE_EXPORT std::vector<ContactSetting> Unique(const std::vector<ContactSetting>& settings);

inline bool operator==(const ContactSetting& a, const ContactSetting& b)
{
  return a.Structure == b.Structure && a.ToolPoints == b.ToolPoints;
}
} // namespace palpate
