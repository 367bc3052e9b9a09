#pragma once

#include "DrillEditor.h"
#include "PalpateSceneModule.h"
#include "SceneContacts.h"
#include "SceneProtection.h"
#include "SceneSettings.h"
#include "TouchScene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// A structure to be drilled.
struct DrillSite
{
  std::string Name;
  DrillSource Source;
};

/// A structure protected from the drill.
struct DrillProtection
{
  std::string Name;
  double AlarmDistance = 0.0; ///< mm
  std::shared_ptr<const SceneProtection> Protection;
};

/// The context of drilling in a scene, without the servo: the editor of the fields, the protected
/// structures and the cutting tool.
class PALPATESCENE_EXPORT DrillContext
{
public:
  /// Makes a site for each drilled one of `contacts`, in their order, protected by those of
  /// `protections` that are on its grid. Returns null if none is drilled. Throws InputError.
  static std::shared_ptr<DrillContext> Make(const SceneSettings& scene,
                                            const std::vector<SceneContact>& contacts,
                                            const std::vector<DrillProtection>& protections);

  /// Makes `scene` drillable; its structures must be those given to Make, in the same order.
  void PutInto(TouchScene& scene) const { this->PutInto(scene, this->SiteOf); }
  /// The same for a scene with other structures: the site of each, -1 if it is not drilled.
  void PutInto(TouchScene& scene, const std::vector<int>& sites) const;
  /// Changes the cutting tool from the next scene on. Throws InputError if the tool cannot cut.
  void UseTool(const TouchToolSettings& tool, const TouchDrillSettings& drill);

  DrillEditor& Editor() const { return *this->Edits; }
  const std::shared_ptr<DrillEditor>& SharedEditor() const { return this->Edits; }
  const std::vector<DrillSite>& Sites() const { return this->Drilled; }
  const std::vector<DrillProtection>& Forbidden() const { return this->Guarded; }
  /// Distance from the cutting tool to each of Forbidden(), mm; negative inside.
  std::vector<double> Distances(const ToolPose& pose) const;

private:
  DrillContext() = default;
  void Add(const std::string& name, const DrillSource& source,
           const std::vector<DrillProtection>& protections,
           std::vector<std::unique_ptr<DrilledField>>& fields);

  std::vector<DrillSite> Drilled;
  std::vector<int> SiteOf; // of each touched structure; -1: not drilled
  std::vector<DrillProtection> Guarded;
  std::shared_ptr<DrillEditor> Edits;
  ToolShape Cutter = ToolShape::Sphere(0.0);
  TouchDrill Drill;
};
} // namespace palpate
