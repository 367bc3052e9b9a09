#pragma once

#include "GuideDistance.h"
#include "PalpateSceneModule.h"
#include "ScenePlan.h"
#include "TouchScene.h"
#include "WorkspaceFrame.h"

#include <functional>
#include <memory>
#include <vector>

namespace palpate
{
/// The newest product of a structure's step, or null.
using SceneProducts = std::function<const SceneProduct*(SceneStep step, int id)>;

/// A structure of a scene that can be touched now.
struct SceneContact
{
  int Id = 0;
  std::shared_ptr<const TouchContact> Contact;
  std::shared_ptr<const ImageEffects> Effects = nullptr; ///< made from images; null: none
  DrillSource Drilled = {}; ///< without a field if it is not, or not yet, drilled
};

/// The touchable structures of a scene whose contact model has been made.
PALPATESCENE_EXPORT std::vector<SceneContact> ContactsOf(const SceneSettings& scene,
                                                         const SceneProducts& products);

/// The distances to the structures that guide the tool, as far as they have been made.
PALPATESCENE_EXPORT GuideDistances GuideDistancesOf(const SceneSettings& scene,
                                                    const SceneProducts& products);

/// Assembles the scene for the servo: one structure for each of `contacts`, which must be
/// touchable, and the guides; those by structures without `distances` are left out. Throws
/// InputError if the settings do not describe a valid tool or guide.
PALPATESCENE_EXPORT TouchScene MakeTouchScene(const SceneSettings& scene,
                                              const std::vector<SceneContact>& contacts,
                                              const WorkspaceFrame& frame,
                                              const GuideDistances& distances = {});
} // namespace palpate
