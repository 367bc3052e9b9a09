#pragma once

#include "ScenePlan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// Plans one structure of a scene: its source, contact and display.
class StructurePlan
{
public:
  using Inputs = std::vector<SceneProduct>;
  using Making = decltype(SceneNode::Make);

  /// Keeps the addresses of its arguments. `tool` is the key of the tool's surface, empty if the
  /// tool is not from a file.
  StructurePlan(const SceneSettings& scene, const SceneStructure& structure, std::string tool,
                const SceneStamps& stamps, const SceneLookup& lookup,
                std::vector<SceneNode>& nodes);

  /// Adds all nodes that touch and display need.
  void Add();
  /// Adds the measurement of its contact's time per tick.
  void AddCost();
  /// Only voxels can be drilled.
  bool HasVoxels() const
  {
    return this->Source == SceneSource::Label || this->Source == SceneSource::IsoValue;
  }
  /// Adds the protection of a forbidden structure on the drilled `fields` (keys); fields that
  /// failed are skipped.
  void AddProtection(const std::vector<std::string>& fields);

  /// Adds the distances to a structure that guides the tool, if it does.
  void AddGuide();

  /// \name For representations. Each product is planned once; the functions return its key.
  ///@{
  const SceneStructure& Settings() const { return this->Structure; }
  const SceneSettings& Whole() const { return this->Scene; }
  /// The segmentation of a label, the image of an iso-value (of a limited one, that of its region).
  std::string AddVoxels();
  /// FitSurface: of a label's mask, of an iso-value, or from a file.
  std::string AddSurface();
  /// FitResult: fitted to a label or a surface, or read from a file.
  std::string AddModel();
  /// ScalarField of a label or an iso-value.
  std::string AddField();
  /// Volume: an image of the structure.
  std::string AddImage(const std::filesystem::path& file, const std::string& series = {});
  /// Segmentation: that of another label of the scene.
  std::string AddSegmentationOf(const SceneStructure& other);
  /// Any other product.
  std::string AddNode(SceneStep step, const std::string& key, std::vector<std::string> inputs,
                      Making make);
  /// The contact of a kind (text that says everything but `input` and the representation's numbers
  /// that it is made by), made from one product; for a drilled structure also from its voxels, as
  /// second input.
  void AddContact(const std::string& kind, const std::string& input, Making make);
  /// Announces a contact that will be planned once `input` is made.
  void AddUndecidedContact(const std::string& input);
  /// The product of a key, or null.
  const SceneProduct* Find(const std::string& key) const { return this->Lookup(key); }
  std::size_t NodeCount() const { return this->Nodes.size(); }
  /// Reason for the first failure among the structure's nodes; empty if none failed.
  std::string FirstFailure() const;
  /// Marks the structure's nodes up to `last` as replaced by `replacement`, unless that fails too.
  void Replace(std::size_t last, const std::string& replacement, const std::string& advice);
  ///@}

private:
  std::string AddFile(SceneNode node);
  std::string Share(SceneNode node, int id);
  std::string AddSegmentation();
  std::string AddSamples();
  std::string AddIsoImage();
  double IsoOfImage() const { return this->Structure.IsLimited() ? 0.0 : *this->Structure.Iso; }
  std::string AddIsoSurface();
  std::string AddProtectedSurface();

  void AddRepresentation();
  void AddOnlyDisplayed();
  void AddAppearance();
  void AddEffects();
  void AddRefusal(const std::string& fact, const std::string& remedy);
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
  std::string ContactKey; // once decided
  std::size_t First;      // of the structure's own nodes
};
} // namespace palpate
