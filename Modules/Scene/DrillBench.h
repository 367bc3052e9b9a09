#pragma once

#include "DrillEditor.h"
#include "ForbiddenStructure.h"
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
/// A structure that is drilled.
struct DrillSite
{
  std::string Name;
  DrillSource Source;
};

/// A structure that no drill may remove.
struct DrillProtection
{
  std::string Name;
  double AlarmDistance = 0.0; ///< mm
  std::shared_ptr<const SceneProtection> Protection;
};

/// All that a scene needs to be drilled, but the servo: who edits the fields, what is forbidden,
/// and the tool that cuts.
class PALPATESCENE_EXPORT DrillBench
{
public:
  /// Makes it of the drilled ones among `contacts`, in their order, each kept out of what
  /// `protections` have on its grid; null where nothing is drilled. Throws InputError.
  static std::shared_ptr<DrillBench> Make(const SceneSettings& scene,
                                          const std::vector<SceneContact>& contacts,
                                          const std::vector<DrillProtection>& protections);

  /// Lets `scene`, which has the structures that the bench was made of, in their order, be drilled.
  void PutInto(TouchScene& scene) const { this->PutInto(scene, this->SiteOf); }
  /// The same of a scene with other structures: the site of each, -1 where it is not drilled.
  void PutInto(TouchScene& scene, const std::vector<int>& sites) const;
  /// Drills by another tool from the next scene on. Throws InputError for one that cannot.
  void UseTool(const TouchToolSettings& tool, const TouchDrillSettings& drill);

  DrillEditor& Editor() const { return *this->Edits; }
  const std::shared_ptr<DrillEditor>& SharedEditor() const { return this->Edits; }
  const std::vector<DrillSite>& Sites() const { return this->Drilled; }
  const std::vector<ForbiddenStructure>& Forbidden() const { return this->Guarded; }
  /// From the tool that cuts to each of them, mm; negative inside.
  std::vector<double> Distances(const ToolPose& pose) const;

private:
  DrillBench() = default;
  void Add(const std::string& name, const DrillSource& source,
           const std::vector<DrillProtection>& protections,
           std::vector<std::unique_ptr<DrilledField>>& fields);

  std::vector<DrillSite> Drilled;
  std::vector<int> SiteOf; // of each structure that is touched; -1: it is not drilled
  std::vector<ForbiddenStructure> Guarded;
  std::shared_ptr<DrillEditor> Edits;
  ToolShape Cutter = ToolShape::Sphere(0.0);
  TouchDrill Drill;
};
} // namespace palpate
