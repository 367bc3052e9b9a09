#include "SessionUpgrade.h"

#include <cstdlib>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
using nlohmann::json;

void Move(json& from, const char* key, json& to, const char* name)
{
  const auto found = from.find(key);
  if (found != from.end())
  {
    to[name] = std::move(*found);
    from.erase(found);
  }
}

// In version 1, the dial set the representation of all structures.
void TurnDial(const std::string& dial, json& structure)
{
  const std::string harmonics = "harmonics-";
  if (dial.rfind(harmonics, 0) == 0)
  {
    structure["representation"] = "model-or-field";
    structure["degree"] = std::atoi(dial.c_str() + harmonics.size());
    structure["interpolation"] = "linear";
  }
  else if (dial == "sub-voxel-linear" || dial == "sub-voxel-cubic")
  {
    structure["representation"] = "sub-voxel";
    structure["interpolation"] = dial == "sub-voxel-cubic" ? "cubic" : "linear";
  }
  else if (dial == "automatic")
  {
    structure["representation"] = "model-or-field";
  }
}

json StructureOf(json old, const json& segmentation, const json& field, const std::string& dial)
{
  json structure = json::object();
  const json label = old.value("label", json(0));
  structure["id"] = label;
  structure["file"] = segmentation;
  structure["label"] =
      label.is_number_integer() ? json(std::to_string(label.get<long long>())) : label;
  old.erase("label");
  Move(old, "visible", structure, "seen");
  Move(old, "touchable", structure, "touched");
  json drill = json::object();
  Move(old, "drill_wear_mm_per_nm", drill, "wear_mm_per_nm");
  Move(old, "drill_drag_s_per_mm", drill, "drag_s_per_mm");
  Move(old, "drill_vibration", drill, "vibration");
  if (!drill.empty())
  {
    structure["drill"] = std::move(drill);
  }
  structure.update(old);
  if (structure.value("representation", json("automatic")) == "automatic")
  {
    structure["representation"] = "model-or-field";
  }
  if (field.is_object())
  {
    structure.update(field);
  }
  TurnDial(dial, structure);
  return structure;
}
// What was a distance is a line. Anything else stays, to be refused.
void MeasureDistances(json& root)
{
  if (!root.is_object() || !root.contains("distances") || !root["distances"].is_array())
  {
    return;
  }
  json lines = root.value("measurements", json::array());
  for (json& distance : root["distances"])
  {
    if (!distance.is_object() || !lines.is_array())
    {
      return;
    }
    json line = {{"kind", "line"}, {"points", json::array()}};
    for (const char* end : {"from_mm", "to_mm"})
    {
      json point = json::object();
      Move(distance, end, point, "position_mm");
      line["points"].push_back(point);
    }
    line.update(distance);
    lines.push_back(line);
  }
  root["measurements"] = std::move(lines);
  root.erase("distances");
}
} // namespace

void UpgradeSession(json& root)
{
  MeasureDistances(root);
  const bool isFirst = root.is_object() &&
                       (root.contains("version") ? root["version"] == 1 : !root.contains("scene"));
  if (!isFirst)
  {
    return;
  }
  json scene = json::object();
  const json segmentation = root.value("segmentation", json(""));
  const json field = root.value("field", json());
  const json dial = root.value("dial", json("by-hand"));
  json structures = root.value("structures", json::array());
  if (structures.is_array() && dial.is_string())
  {
    for (json& structure : structures)
    {
      structure = structure.is_object()
                      ? StructureOf(std::move(structure), segmentation, field, dial)
                      : std::move(structure);
    }
  }
  scene["structures"] = std::move(structures);
  root.erase("structures");
  root.erase("field");
  root.erase("dial");
  for (const char* key : {"left_handed", "fit", "tool", "drill", "device", "rate_hz", "placement"})
  {
    Move(root, key, scene, key);
  }
  root["scene"] = std::move(scene);
  root["version"] = 2;
}
} // namespace palpate
