#pragma once

#include "DrillEditor.h"
#include "ForbiddenStructure.h"
#include "PalpateSessionModule.h"
#include "TouchScene.h"
#include "TouchSettings.h"
#include "TouchStructures.h"

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

/// All that a scene needs to be drilled, but the servo: who edits the fields, what is forbidden,
/// and the tool that cuts.
class PALPATESESSION_EXPORT DrillBench
{
public:
  /// Makes it of what is drilled among `made.Touched`, in their order, and takes `made.Forbidden`;
  /// nothing where nothing is drilled. Throws InputError, FilterError and Cancelled.
  static std::shared_ptr<DrillBench> Make(const TouchSettings& settings, TouchStructures& made,
                                          const ProgressFunction& progress);
  /// The same with protections that are there already: `protect` gives what no drill may remove on
  /// the grid of `like`, or nothing where all may be.
  using Protect =
      std::function<std::shared_ptr<const RemovedDistances>(const RemovedDistances& like)>;
  static std::shared_ptr<DrillBench> Make(const TouchSettings& settings, TouchStructures& made,
                                          const Protect& protect);

  /// Lets `scene`, which has the structures that the bench was made of, in their order, be drilled.
  void PutInto(TouchScene& scene) const { this->PutInto(scene, this->SiteOf); }
  /// The same of a scene with other structures: the site of each, -1 where it is not drilled.
  void PutInto(TouchScene& scene, const std::vector<int>& sites) const;
  /// Drills by another tool from the next scene on. Throws InputError for one that cannot.
  void UseTool(const TouchToolSettings& tool, const TouchDrillSettings& drill);

  DrillEditor& Editor() const { return *this->Edits; }
  const std::vector<DrillSite>& Sites() const { return this->Drilled; }
  const std::vector<ForbiddenStructure>& Forbidden() const { return this->Guarded; }
  /// From the tool that cuts to each of them, mm; negative inside.
  std::vector<double> Distances(const ToolPose& pose) const;

private:
  DrillBench() = default;
  void Add(const TouchableStructure& structure, const Protect& protect,
           std::vector<std::unique_ptr<DrilledField>>& fields);

  std::vector<DrillSite> Drilled;
  std::vector<int> SiteOf; // of each structure that is touched; -1: it is not drilled
  std::vector<ForbiddenStructure> Guarded;
  std::unique_ptr<DrillEditor> Edits;
  ToolShape Cutter = ToolShape::Sphere(0.0);
  TouchDrill Drill;
};
} // namespace palpate
