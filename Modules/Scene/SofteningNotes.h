#pragma once

#include "PalpateSceneModule.h"
#include "SceneContacts.h"

#include <string>
#include <vector>

namespace palpate
{
/// A warning on a structure's model, or on what it yields by.
struct SofteningNote
{
  int Id = 0; ///< of the structure that it is on: an inclusion, or one that yields
  std::string Text;
};

/// What models change of their structures (StructureChanges); warnings on inclusions that lie
/// outside, or mostly outside, of all structures that yield, on images without effect, and on sharp
/// hollows. Inclusions are judged once they have been compared with all those structures.
PALPATESCENE_EXPORT std::vector<SofteningNote> SofteningNotes(const SceneSettings& scene,
                                                              const SceneProducts& products);
} // namespace palpate
