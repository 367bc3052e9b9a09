#include "TouchToolJson.h"

#include "JsonFields.h"

namespace palpate
{
namespace
{
constexpr double LargestLength = 1e4; // mm

const std::initializer_list<const char*> ShapeWords{"sphere", "capsule", "ellipsoid"};
} // namespace

TouchToolSettings ReadTouchTool(const nlohmann::json& object, const std::filesystem::path& file)
{
  TouchToolSettings tool;
  JsonFields fields(object, file, "tool");
  fields.ReadChoice("shape", ShapeWords, tool.Kind);
  fields.Read("radius_mm", tool.Radius, 0.0, LargestLength);
  fields.Read("length_mm", tool.Length, 0.0, LargestLength);
  fields.Read("semi_axes_mm", tool.SemiAxes, 0.0, LargestLength);
  fields.Read("points", tool.Points, 0, ToolShape::MaximumCount);
  fields.RefuseOthers();
  return tool;
}

nlohmann::ordered_json TouchToolJson(const TouchToolSettings& tool)
{
  return {{"shape", WordOf(ShapeWords, tool.Kind)},
          {"radius_mm", tool.Radius},
          {"length_mm", tool.Length},
          {"semi_axes_mm", {tool.SemiAxes[0], tool.SemiAxes[1], tool.SemiAxes[2]}},
          {"points", tool.Points}};
}
} // namespace palpate
