#pragma once

#include "ScenePlan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// Plans one structure of a scene: its source, what it is touched by and what it is displayed as.
class StructurePlan
{
public:
  /// Keeps the addresses. `tool` is the key of the tool's surface, empty where the tool is not from
  /// a file.
  StructurePlan(const SceneSettings& scene, const SceneStructure& structure, std::string tool,
                const SceneStamps& stamps, const SceneLookup& lookup,
                std::vector<SceneNode>& nodes);

  /// Everything that is needed to touch and to display it.
  void Add();
  /// Measures what its contact costs each tick.
  void AddCost();
  /// Only voxels can be drilled.
  bool HasVoxels() const
  {
    return this->Source == SceneSource::Label || this->Source == SceneSource::IsoValue;
  }
  /// The key of the field that it is drilled in.
  std::string AddDrilledField();
  /// The protection of a forbidden one from what drills `fields`, by their keys: fields that failed
  /// are not drilled.
  void AddProtection(const std::vector<std::string>& fields);

private:
  using Inputs = std::vector<SceneProduct>;
  using Making = decltype(SceneNode::Make);

  std::string AddNode(SceneStep step, const std::string& key, std::vector<std::string> inputs,
                      Making make);
  std::string AddFile(SceneNode node);
  std::string Share(SceneNode node);
  std::string AddSegmentation();
  std::string AddImage(const std::filesystem::path& file);
  std::string AddSurface();
  std::string AddSamples();
  std::string AddModel();
  std::string AddField();
  std::string AddIsoSurface();
  std::string AddProtectedSurface();

  void AddRepresentation();
  void AddAutomatic();
  void AddOnlyDisplayed();
  void AddAppearance();
  void AddContact(const std::string& input, Making make, bool isDecided = true);
  void AddTexture();
  void AddRefusal(const std::string& fact, const std::string& wayOut);
  std::string WithTool(const std::string& start) const;
  Making ContactOfModel() const;
  Making ContactOfSurface() const;
  Making ContactOfField() const;
  std::string ReasonAt(std::size_t node) const;
  void Advise(std::size_t last, const std::string& advice, const std::string& replacement);

  const SceneSettings& Scene;
  const SceneStructure& Structure;
  const SceneStamps& Stamps;
  const SceneLookup& Lookup;
  std::vector<SceneNode>& Nodes;
  FitSettings Fit;
  SceneSource Source;
  std::string ToolKey;
  std::string ContactKey; // once it is decided
  std::size_t First;      // of the structure's own nodes
};
} // namespace palpate
