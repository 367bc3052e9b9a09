#include "ScenePlan.h"

#include "SceneReading.h"
#include "StructurePlan.h"

#include <array>

namespace palpate
{
const char* NameOf(SceneStep step)
{
  constexpr std::array<const char*, SceneStepCount> Names{
      "volume", "segmentation", "image",      "structures", "surface", "samples",
      "model",  "elasticity",   "field",      "protection", "touch",   "effects",
      "cost",   "tool",         "inclusions", "guide"};
  return Names.at(static_cast<std::size_t>(step));
}

void PlanScene(const SceneSettings& scene, const SceneStamps& stamps, const SceneLookup& lookup,
               bool measuresCosts, std::vector<SceneNode>& nodes)
{
  std::string tool;
  if (scene.Tool.Kind == TouchToolSettings::Shape::Surface)
  {
    nodes.push_back(ToolNode(scene, stamps));
    tool = nodes.back().Key;
  }
  std::vector<std::string> drilled;
  for (const SceneStructure& structure : scene.Structures)
  {
    if (structure.IsVisible || structure.IsTouchable)
    {
      StructurePlan plan(scene, structure, tool, stamps, lookup, nodes);
      plan.Add();
      if (structure.IsDrilled() && plan.HasVoxels())
      {
        drilled.push_back(plan.AddField());
      }
      if (measuresCosts)
      {
        plan.AddCost();
      }
    }
  }
  for (const SceneStructure& structure : scene.Structures)
  {
    StructurePlan plan(scene, structure, tool, stamps, lookup, nodes);
    if (structure.IsForbidden)
    {
      plan.AddProtection(drilled);
    }
    plan.AddGuide();
  }
}
} // namespace palpate
