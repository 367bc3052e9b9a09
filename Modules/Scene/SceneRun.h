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
/// Makes what scenes need on the caller's thread, and keeps the products by their keys: scenes that
/// differ in a setting share what does not depend on it. Copies share the products made so far.
class PALPATESCENE_EXPORT SceneRun
{
public:
  /// `keepsFiles`: for further scenes of the same files. Otherwise the content of a file is
  /// released once nothing that is left to be made needs it.
  explicit SceneRun(bool keepsFiles) : KeepsFiles(keepsFiles) {}

  /// Reads a segmentation, once. Throws InputError and Cancelled.
  std::shared_ptr<const Segmentation> SegmentationOf(const std::filesystem::path& file,
                                                     LeftHandedAxes leftHanded,
                                                     const ProgressFunction& progress);

  /// Makes everything that a scene with resolved labels needs (see PlanScene). Throws InputError if
  /// something cannot be made and nothing replaces it, FilterError and Cancelled.
  void Make(const SceneSettings& scene, const ProgressFunction& progress);

  /// The product of a step of the last scene, of one of its structures; null if there is none.
  const SceneProduct* ProductAt(SceneStep step, int id) const;
  /// Time to make everything that the last scene needs for one structure, without reading files.
  double SecondsOf(int id) const;
  /// The files that were read, in that order.
  const std::vector<SceneFileAccount>& Files() const { return this->Read; }

private:
  const SceneProduct* Find(const std::string& key) const;
  bool IsReady(const SceneNode& node) const;
  void RunNode(const SceneSettings& scene, std::size_t number, const ProgressFunction& progress);
  void Run(const SceneNode& node, const ProgressFunction& progress);
  void Release(std::size_t number);
  static void RequireMade(const SceneSettings& scene, const SceneNode& node,
                          const SceneProduct* product);

  bool KeepsFiles;
  std::vector<SceneNode> Plan; // of the last scene
  std::map<std::string, SceneProduct> Products;
  std::map<std::string, double> Seconds; // of a key
  std::vector<SceneFileAccount> Read;
};
} // namespace palpate
