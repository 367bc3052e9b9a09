#include "DrillBench.h"

#include "DrillTool.h"
#include "Refusal.h"

#include <algorithm>
#include <limits>

namespace palpate
{
std::shared_ptr<DrillBench> DrillBench::Make(const TouchSettings& settings, TouchStructures& made,
                                             const ProgressFunction& progress)
{
  const auto protect = [&](const RemovedDistances& like) -> std::shared_ptr<const RemovedDistances>
  {
    std::vector<std::shared_ptr<const RemovedDistances>> parts;
    for (const ForbiddenStructure& structure : made.Forbidden)
    {
      parts.push_back(ProtectionOf(structure, like, progress));
    }
    return parts.empty() ? nullptr : JoinProtections(parts);
  };
  return Make(settings, made, Protect(protect));
}

std::shared_ptr<DrillBench> DrillBench::Make(const TouchSettings& settings, TouchStructures& made,
                                             const Protect& protect)
{
  std::shared_ptr<DrillBench> bench(new DrillBench);
  std::vector<std::unique_ptr<DrilledField>> fields;
  double voxel = std::numeric_limits<double>::max();
  for (const TouchableStructure& structure : made.Touched)
  {
    bench->SiteOf.push_back(structure.Drilled.Field != nullptr ? static_cast<int>(fields.size())
                                                               : -1);
    if (structure.Drilled.Field != nullptr)
    {
      bench->Add(structure, protect, fields);
      voxel = std::min(voxel, structure.Drilled.Field->Grid().Spacing().minCoeff());
    }
  }
  bench->Guarded = std::move(made.Forbidden);
  if (fields.empty())
  {
    return nullptr;
  }
  RequireInput(DrillEditor::Make(std::move(fields), bench->Edits), "the scene cannot be drilled");
  constexpr double ClearanceInVoxels = 0.1;
  bench->Drill.Link = bench->Edits->Link();
  bench->Drill.Clearance = ClearanceInVoxels * voxel;
  bench->UseTool(settings.Tool, settings.Drill);
  return bench;
}

void DrillBench::UseTool(const TouchToolSettings& tool, const TouchDrillSettings& drill)
{
  const CutTool cutting = MakeCutTool(tool);
  RequireInput(this->Edits->AddTool(cutting, this->Drill.Tool), "the tool cannot drill");
  this->Cutter = MakeTool(tool);
  this->Drill.Motion = {DrillRadius(tool, cutting), drill.Turns, drill.VibrationFrequency};
}

void DrillBench::Add(const TouchableStructure& structure, const Protect& protect,
                     std::vector<std::unique_ptr<DrilledField>>& fields)
{
  std::unique_ptr<DrilledField> field;
  const std::string& name = structure.Touch.Name;
  RequireInput(DrilledField::Make(*structure.Drilled.Field, 0, field), name + " cannot be drilled");
  if (const auto forbidden = protect(field->Now()))
  {
    RequireInput(field->Protect(forbidden), name + " cannot be drilled");
  }
  fields.push_back(std::move(field));
  this->Drilled.push_back({name, structure.Drilled});
}

void DrillBench::PutInto(TouchScene& scene, const std::vector<int>& sites) const
{
  scene.Drill = this->Drill;
  scene.Tool = MakeClearTool(scene.Tool, this->Drill.Clearance);
  for (std::size_t s = 0; s < scene.Structures.size(); ++s)
  {
    scene.Structures[s].Site = sites[s];
  }
}

std::vector<double> DrillBench::Distances(const ToolPose& pose) const
{
  std::vector<double> distances;
  for (const ForbiddenStructure& structure : this->Guarded)
  {
    distances.push_back(structure.Distance(this->Cutter, pose));
  }
  return distances;
}
} // namespace palpate
