#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneProduct.h"
#include "SceneSettings.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// Stamps of a scene's files; see StampOf.
using SceneStamps = std::map<std::filesystem::path, std::string>;

/// Steps from files to touch. Volume, segmentation and tool belong to the whole scene, the others
/// to a structure.
enum class SceneStep
{
  Volume,
  Segmentation,
  Image,      ///< of an iso-value or a force effect
  Structures, ///< resolved from the labels of the segmentation
  Surface,
  Samples,
  Model,
  Elasticity, ///< the model of a structure that yields, with its compliance
  Field,      ///< for sub-voxel structures
  Protection, ///< of a forbidden structure; no drilling before it is done
  Touch,      ///< the contact model
  Effects,    ///< force effects made from images
  Cost,       ///< measured time per tick; no step waits for it
  Tool,       ///< if it is a surface from a file
  Inclusions, ///< how much of each inclusion lies in a structure that yields
  Guide       ///< distances to a structure that guides the tool
};
constexpr int SceneStepCount = 16;

/// "volume", "segmentation", ...
PALPATESCENE_EXPORT const char* NameOf(SceneStep step);

/// A node of the plan: one product to be made.
struct SceneNode
{
  SceneStep Step = SceneStep::Volume;
  int Id = 0; ///< of the structure; 0 for the whole scene
  /// Identifies all inputs and settings: nodes with equal keys have the same product. Empty if not
  /// decided yet.
  std::string Key;
  std::vector<std::string> Inputs; ///< keys
  std::filesystem::path Reads;     ///< the file that it reads; may be empty
  /// If this node or one of its inputs failed and another product replaces it: a message that names
  /// the replacement and the reason. The scene has not failed then. Otherwise empty.
  std::string Advice;
  std::string Replacement; ///< the key of the replacement
  /// Throws InputError, FilterError and Cancelled.
  std::function<SceneProduct(const std::vector<SceneProduct>& inputs,
                             const ProgressFunction& progress)>
      Make;
};

/// Returns the existing product of a key, or null.
using SceneLookup = std::function<const SceneProduct*(const std::string& key)>;

/// Appends the nodes that a scene with resolved labels (see ResolveLabels) needs, inputs before
/// their dependents: only those required by structures that are displayed or touched, the
/// protection of every forbidden one, and the distances to those that guide. File nodes that are
/// already in `nodes` are shared.
PALPATESCENE_EXPORT void PlanScene(const SceneSettings& scene, const SceneStamps& stamps,
                                   const SceneLookup& lookup, bool measuresCosts,
                                   std::vector<SceneNode>& nodes);
} // namespace palpate
