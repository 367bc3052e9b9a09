#include "ScenePlan.h"

#include "SceneReading.h"
#include "StructurePlan.h"

#include <array>
#include <system_error>

namespace palpate
{
namespace
{
std::string OwnStampOf(const std::filesystem::path& file)
{
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error)
  {
    return "absent";
  }
  const auto size = std::filesystem::file_size(file, error); // a folder has none
  return std::to_string(time.time_since_epoch().count()) + "|" + std::to_string(error ? 0 : size);
}
} // namespace

const char* NameOf(SceneStep step)
{
  constexpr std::array<const char*, SceneStepCount> Names{
      "volume", "segmentation", "image", "structures", "surface", "samples", "model",
      "field",  "protection",   "touch", "effects",    "cost",    "tool"};
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
    if (structure.IsForbidden)
    {
      StructurePlan(scene, structure, tool, stamps, lookup, nodes).AddProtection(drilled);
    }
  }
}

// Companion files: names and colours of a label map's labels (see ApplyLabelNames), and data
// detached from their header. A missing one costs only a directory look-up.
std::string StampOf(const std::filesystem::path& file)
{
  std::string stamps = OwnStampOf(file);
  std::filesystem::path stem = file;
  const bool isCompressed = stem.extension() == ".gz";
  stem = isCompressed ? stem.replace_extension() : stem;
  for (const char* ending : {".txt", ".lut"})
  {
    stamps += "|" + OwnStampOf(std::filesystem::path(stem).concat(ending));
  }
  for (const char* ending : {".raw", ".zraw", ".raw.gz", ".img"})
  {
    stamps += "|" + OwnStampOf(std::filesystem::path(stem).replace_extension(ending));
  }
  return stamps;
}
} // namespace palpate
