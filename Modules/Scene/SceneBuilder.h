#pragma once

#include "DrillBench.h"
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
/// A structure ready to be touched and to be drawn.
struct BuiltStructure
{
  TouchStructure Touch;    ///< without a model where it is only displayed
  TouchAppearance Looks;   ///< empty where it is not displayed
  DrillSource Drilled;     ///< without a field: it is not drilled
  std::string Represented; ///< in words, such as "harmonics of degree 12, nearest point"
  double Seconds = 0.0;    ///< to make
};

/// Everything that a scene needs, and an account of it.
struct BuiltScene
{
  SceneSettings Settings; ///< with its labels resolved
  std::vector<SceneContact> Contacts;
  std::vector<BuiltStructure> Touched; ///< one for each contact
  std::vector<BuiltStructure> OnlyDisplayed;
  std::vector<DrillProtection>
      Protections; ///< of structures that are touched, displayed, or neither
  SceneAccount Account;
};

/// Reads the files and makes the models on the caller's thread, each only as the settings ask, and
/// nothing else; drawings only where `isSeen`. Touched voxels are drawn by their field; voxels that
/// are only displayed have a surface. Throws InputError, FilterError and Cancelled.
PALPATESCENE_EXPORT BuiltScene BuildScene(const SceneSettings& settings, bool isSeen,
                                          const ProgressFunction& progress);

/// What a servo adds in order to follow the touched structures, made once to be measured. Throws
/// InputError where the tool cannot touch them.
PALPATESCENE_EXPORT SceneItem AccountForServo(const BuiltScene& built);
} // namespace palpate
