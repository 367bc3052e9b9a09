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
  using Inputs = std::vector<SceneProduct>;
  using Making = decltype(SceneNode::Make);

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

  /// \name For representations. Each product is planned once; the functions return its key.
  ///@{
  const SceneStructure& Settings() const { return this->Structure; }
  /// Of a label a segmentation, of an iso-value an image.
  std::string AddVoxels();
  /// FitSurface: of a label its mask's, of an iso-value or a file its own.
  std::string AddSurface();
  /// FitResult: fitted to a label or a surface, or read.
  std::string AddModel();
  /// ScalarField of a label or an iso-value.
  std::string AddField();
  /// Any other product.
  std::string AddNode(SceneStep step, const std::string& key, std::vector<std::string> inputs,
                      Making make);
  /// The contact, made from one product; of a drilled structure also from its voxels, the second
  /// input.
  void AddContact(const std::string& input, Making make);
  /// Shows that a contact will follow once `input` is made.
  void AddUndecidedContact(const std::string& input);
  /// What was made of a key, or null.
  const SceneProduct* Find(const std::string& key) const { return this->Lookup(key); }
  std::size_t NodeCount() const { return this->Nodes.size(); }
  /// Why the first of the structure's nodes that failed has failed; empty without any.
  std::string FirstFailure() const;
  /// Says of its nodes up to `last` that `replacement` is used instead, unless that fails too.
  void Replace(std::size_t last, const std::string& replacement, const std::string& advice);
  ///@}

private:
  std::string AddFile(SceneNode node);
  std::string Share(SceneNode node);
  std::string AddSegmentation();
  std::string AddImage(const std::filesystem::path& file);
  std::string AddSamples();
  std::string AddIsoSurface();
  std::string AddProtectedSurface();

  void AddRepresentation();
  void AddOnlyDisplayed();
  void AddAppearance();
  void AddEffects();
  void AddRefusal(const std::string& fact, const std::string& wayOut);
  std::string WithTool(const std::string& start) const;
  std::string ReasonAt(std::size_t node) const;

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
