#include "DrillContext.h"

#include "Refusal.h"
#include "SceneTool.h"

#include <algorithm>
#include <limits>

namespace palpate
{
std::shared_ptr<DrillContext> DrillContext::Make(const SceneSettings& scene,
                                                 const std::vector<SceneContact>& contacts,
                                                 const std::vector<DrillProtection>& protections)
{
  std::shared_ptr<DrillContext> context(new DrillContext);
  std::vector<std::unique_ptr<DrilledField>> fields;
  double voxel = std::numeric_limits<double>::max();
  for (const SceneContact& contact : contacts)
  {
    const bool isDrilled = contact.Drilled.Field != nullptr;
    context->SiteOf.push_back(isDrilled ? static_cast<int>(fields.size()) : -1);
    if (isDrilled)
    {
      context->Add(TitleOf(*FindStructure(scene, contact.Id)), contact.Drilled, protections,
                   fields);
      voxel = std::min(voxel, contact.Drilled.Field->Grid().Spacing().minCoeff());
    }
  }
  if (fields.empty())
  {
    return nullptr;
  }
  context->Guarded = protections;
  std::unique_ptr<DrillEditor> editor;
  RequireInput(DrillEditor::Make(std::move(fields), editor), "the scene cannot be drilled");
  context->Edits = std::move(editor);
  constexpr double ClearanceInVoxels = 0.1;
  context->Drill.Link = context->Edits->Link();
  context->Drill.Clearance = ClearanceInVoxels * voxel;
  context->UseTool(scene.Tool, scene.Drill);
  return context;
}

void DrillContext::UseTool(const TouchToolSettings& tool, const TouchDrillSettings& drill)
{
  const CutTool cutting = MakeCutTool(tool);
  RequireInput(this->Edits->AddTool(cutting, this->Drill.Tool), "the tool cannot drill");
  this->Cutter = MakeTool(tool);
  this->Drill.Motion = {DrillRadius(tool, cutting), drill.Turns, drill.VibrationFrequency};
}

void DrillContext::Add(const std::string& name, const DrillSource& source,
                       const std::vector<DrillProtection>& protections,
                       std::vector<std::unique_ptr<DrilledField>>& fields)
{
  std::unique_ptr<DrilledField> field;
  RequireInput(DrilledField::Make(*source.Field, 0, field), name + " cannot be drilled");
  std::vector<std::shared_ptr<const RemovedDistances>> parts;
  for (const DrillProtection& one : protections)
  {
    if (auto part = one.Protection->On(field->Now()))
    {
      parts.push_back(std::move(part));
    }
  }
  if (!parts.empty())
  {
    RequireInput(field->Protect(JoinProtections(parts)), name + " cannot be drilled");
  }
  fields.push_back(std::move(field));
  this->Drilled.push_back({name, source});
}

void DrillContext::PutInto(TouchScene& scene, const std::vector<int>& sites) const
{
  scene.Drill = this->Drill;
  // In a hole of its own size a tool would wedge.
  scene.Tool =
      scene.Tool.Variant(static_cast<int>(scene.Tool.Points().size()), this->Drill.Clearance);
  for (std::size_t s = 0; s < scene.Structures.size(); ++s)
  {
    scene.Structures[s].Site = sites[s];
  }
}

std::vector<double> DrillContext::Distances(const ToolPose& pose) const
{
  std::vector<double> distances;
  for (const DrillProtection& one : this->Guarded)
  {
    distances.push_back(one.Protection->Structure->Distance(this->Cutter, pose));
  }
  return distances;
}
} // namespace palpate
