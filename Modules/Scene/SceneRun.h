#pragma once

#include "PalpateSceneModule.h"
#include "SceneAccount.h"
#include "ScenePlan.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// Makes the products of scenes on the caller's thread, and keeps them by their keys: scenes that
/// differ in a setting share the products that do not depend on it. Copies share the products made
/// so far.
class PALPATESCENE_EXPORT SceneRun
{
public:
  /// Reads a segmentation, once. Throws InputError and Cancelled.
  std::shared_ptr<const Segmentation> SegmentationOf(const std::filesystem::path& file,
                                                     LeftHandedAxes leftHanded,
                                                     const ProgressFunction& progress);

  /// Makes everything that a scene with resolved labels needs (see PlanScene). Throws InputError if
  /// a product cannot be made and has no replacement, FilterError and Cancelled.
  void Make(const SceneSettings& scene, const ProgressFunction& progress);

  /// The product of a step for a structure of the last scene, or null.
  const SceneProduct* ProductAt(SceneStep step, int id) const;
  /// Time to make the products of one structure of the last scene, without reading files.
  double SecondsOf(int id) const;
  /// The files that were read, in order.
  const std::vector<SceneFileAccount>& Files() const { return this->Read; }

private:
  const SceneProduct* Find(const std::string& key) const;
  bool IsReady(const SceneNode& node) const;
  void RunNode(const SceneSettings& scene, std::size_t number, const ProgressFunction& progress);
  void Run(const SceneNode& node, const ProgressFunction& progress);
  static void RequireMade(const SceneSettings& scene, const SceneNode& node,
                          const SceneProduct* product);

  std::vector<SceneNode> Plan; // of the last scene
  std::map<std::string, SceneProduct> Products;
  std::map<std::string, double> Seconds; // of a key
  std::vector<SceneFileAccount> Read;
};
} // namespace palpate
