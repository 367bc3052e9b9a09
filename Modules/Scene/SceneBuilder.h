#pragma once

#include "DrillContext.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneAccount.h"
#include "SceneContacts.h"
#include "SceneSettings.h"
#include "TouchScene.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// A structure ready to be touched and drawn.
struct BuiltStructure
{
  TouchStructure Touch;    ///< without a model if it is only displayed
  TouchAppearance Looks;   ///< empty if it is not displayed
  DrillSource Drilled;     ///< without a field if it is not drilled
  std::string Represented; ///< "harmonics of degree 12, nearest point"
  double Seconds = 0.0;    ///< build time
};

/// All products of a scene, and an account of them.
struct BuiltScene
{
  SceneSettings Settings; ///< with resolved labels
  std::vector<SceneContact> Contacts;
  std::vector<BuiltStructure> Touched; ///< one for each contact
  std::vector<BuiltStructure> OnlyDisplayed;
  std::vector<DrillProtection>
      Protections; ///< of forbidden structures, whether touched, displayed or neither
  SceneAccount Account;
};

/// Reads the files and makes the models on the caller's thread, only what the settings require;
/// what is displayed only if `isSeen`. Touched voxels are drawn by their field; voxels that are
/// only displayed get a surface. Throws InputError, FilterError and Cancelled.
PALPATESCENE_EXPORT BuiltScene BuildScene(const SceneSettings& settings, bool isSeen,
                                          const ProgressFunction& progress);

/// Memory and time that a servo needs to track the touched structures, measured by building the
/// trackers once. Throws InputError if the tool cannot touch them.
PALPATESCENE_EXPORT SceneItem AccountForServo(const BuiltScene& built);
} // namespace palpate
