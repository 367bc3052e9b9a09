#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneProduct.h"
#include "SceneSettings.h"
#include "SceneStamps.h"

#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// From files to touch. Volume, segmentation and tool belong to the whole scene, the others to a
/// structure.
enum class SceneStep
{
  Volume,
  Segmentation,
  Image,      ///< of an iso-value or a force effect
  Structures, ///< those of the scene, found in the segmentation
  Surface,
  Samples,
  Model,
  Field,      ///< for sub-voxel structures
  Protection, ///< of a forbidden structure from the drill; nothing is drilled before it
  Touch,      ///< the contact model
  Effects,    ///< the force effects that are made from images
  Cost,       ///< what that costs a tick, measured; nothing waits for it
  Tool        ///< if it is a surface from a file
};
constexpr int SceneStepCount = 13;

/// "volume", "segmentation", ...
PALPATESCENE_EXPORT const char* NameOf(SceneStep step);

/// One thing to be made.
struct SceneNode
{
  SceneStep Step = SceneStep::Volume;
  int Id = 0; ///< of the structure; 0 for the whole scene
  /// Everything it is made from: two nodes of one key have the same product. Empty where that is
  /// not decided yet.
  std::string Key;
  std::vector<std::string> Inputs; ///< keys
  std::filesystem::path Reads;     ///< the file that it reads; empty where it reads none
  /// Where something else replaces its work: a message that says what, and why. It has failed then,
  /// or an input has, and that is no failure of the scene's. Empty without.
  std::string Advice;
  std::string Replacement; ///< the key of the replacement
  /// Throws InputError, FilterError and Cancelled.
  std::function<SceneProduct(const std::vector<SceneProduct>& inputs,
                             const ProgressFunction& progress)>
      Make;
};

/// The product of a key that is there already, or null.
using SceneLookup = std::function<const SceneProduct*(const std::string& key)>;

/// Appends everything that a scene needs to be made, inputs before what is made from them: only
/// what its representations need of structures that are displayed or touched, and the protection of
/// all that are forbidden. The scene's labels are resolved (see ResolveLabels). Nodes of files that
/// are in `nodes` already are shared.
PALPATESCENE_EXPORT void PlanScene(const SceneSettings& scene, const SceneStamps& stamps,
                                   const SceneLookup& lookup, bool measuresCosts,
                                   std::vector<SceneNode>& nodes);
} // namespace palpate
