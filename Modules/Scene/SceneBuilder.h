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
/// A structure ready to be touched.
struct BuiltStructure
{
  TouchStructure Touch;
  std::string Represented; ///< "harmonics of degree 12, nearest point"
  bool Yields = false;     ///< see TouchContact
  double Seconds = 0.0;    ///< build time
};

/// Handling of masks that cannot be read or are empty, among others that can.
enum class BadMasks
{
  Refuse,  ///< a scene that names them is wrong
  LeaveOut ///< such as of a folder, in which organs may be absent
};

/// All products of a scene, and an account of them.
struct BuiltScene
{
  SceneSettings Settings; ///< with resolved labels
  std::vector<SceneContact> Contacts;
  GuideDistances Distances;
  std::vector<BuiltStructure> Touched;      ///< one for each contact
  std::vector<DrillProtection> Protections; ///< of forbidden structures, touched or not
  SceneAccount Account;
  std::vector<std::string>
      Warnings; ///< on what structures yield by (SofteningNotes), and on cut ones
  std::vector<std::string> LeftOut; ///< why, of each mask (BadMasks::LeaveOut)
};

/// Reads the files and makes the models on the caller's thread, only what the settings require;
/// and nothing for display. Throws InputError, FilterError and Cancelled; for a bad mask that would
/// be left out if it is the only structure.
PALPATESCENE_EXPORT BuiltScene BuildScene(const SceneSettings& settings,
                                          const ProgressFunction& progress,
                                          BadMasks badMasks = BadMasks::Refuse);

/// Memory and time that a servo needs to track the touched structures, measured by building the
/// trackers once. Throws InputError if the tool cannot touch them.
PALPATESCENE_EXPORT SceneItem AccountForServo(const BuiltScene& built);
} // namespace palpate
