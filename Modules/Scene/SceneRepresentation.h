#pragma once

#include "PalpateSceneModule.h"
#include "SceneEffect.h"
#include "SceneSettings.h"

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

/// A way to represent structures for touch. Functions that are empty do not apply.
struct SceneRepresentation
{
  std::string Name;  ///< in files and options: "sub-voxel"
  std::string Label; ///< in the window
  std::vector<SceneSource> Sources;
  bool CanBeDrilled = false;
  /// What SceneAppearance::Automatic displays of a label, unless drilled.
  SceneAppearance Appearance = SceneAppearance::Surface;
  std::vector<SceneNumber> Numbers; ///< of a structure, besides its members
  /// Adds the contact and what it is made from.
  std::function<void(StructurePlan& plan)> PlanContact;
  /// Adds what a label is displayed as that is not touched; its surface if empty.
  std::function<void(StructurePlan& plan)> PlanDisplay;
  /// "harmonics of degree 12, nearest point".
  std::function<std::string(const ContactSetting& setting)> Describe;
  /// Short text that does not change from version to version: "harmonics/12/nearest".
  std::function<std::string(const ContactSetting& setting)> KeyOf;
  /// The settings whose speed and accuracy are worth comparing, beginning with `standard`, whose
  /// representation is this. `highestDegree`: that the voxels of a label support.
  std::function<std::vector<ContactSetting>(const ContactSetting& standard,
                                            const TouchToolSettings& tool, int highestDegree)>
      Vary;

  PALPATESCENE_EXPORT bool Takes(SceneSource source) const;
};

/// Automatic, harmonics, facets, sub-voxel, model-or-field, then those that were added.
PALPATESCENE_EXPORT const std::vector<SceneRepresentation>& SceneRepresentations();

/// Adds a representation for the whole program, before the first scene is read or shown.
PALPATESCENE_EXPORT void AddSceneRepresentation(SceneRepresentation representation);

/// Throws InputError if there is no representation of that name.
PALPATESCENE_EXPORT const SceneRepresentation& RepresentationOf(const SceneStructure& structure);

/// The settings without repetition, in their order.
PALPATESCENE_EXPORT std::vector<ContactSetting> Unique(const std::vector<ContactSetting>& settings);

inline bool operator==(const ContactSetting& a, const ContactSetting& b)
{
  return a.Structure == b.Structure && a.ToolPoints == b.ToolPoints;
}
} // namespace palpate
