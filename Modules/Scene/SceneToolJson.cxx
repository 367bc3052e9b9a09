#include "SceneToolJson.h"

#include "JsonFields.h"
#include "Refusal.h"

#include <system_error>

namespace palpate
{
namespace
{
constexpr double LargestLength = 1e4; // mm

const std::initializer_list<const char*> ShapeWords{"sphere", "capsule", "ellipsoid", "cylinder",
                                                    "surface"};
} // namespace

TouchToolSettings ReadSceneTool(const nlohmann::json& object, const std::filesystem::path& folder,
                                const std::filesystem::path& file)
{
  TouchToolSettings tool;
  JsonFields fields(object, file, "tool");
  fields.Exchange("shape", tool.Kind, ShapeWords);
  fields.Exchange("radius_mm", tool.Radius, 0.0, LargestLength);
  fields.Exchange("length_mm", tool.Length, 0.0, LargestLength);
  fields.Exchange("semi_axes_mm", tool.SemiAxes, 0.0, LargestLength);
  std::string surface;
  fields.Exchange("file", surface);
  if (surface.empty() == (tool.Kind == TouchToolSettings::Shape::Surface))
  {
    Refuse(file, "has a tool whose shape and file contradict each other",
           "give a \"file\" for the shape \"surface\", and for no other");
  }
  tool.File = surface.empty() ? std::filesystem::path()
                              : (folder / std::filesystem::u8path(surface)).lexically_normal();
  fields.Exchange("points", tool.Points, 0, ToolShape::MaximumCount);
  fields.RefuseOthers();
  return tool;
}

std::string RelativeFile(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  std::error_code failure;
  std::filesystem::path relative = std::filesystem::proximate(file, folder, failure);
  relative = failure ? file.lexically_proximate(folder) : relative;
  // With symbolic links a relative path may lead elsewhere.
  const bool leadsElsewhere = file.is_absolute() && folder.is_absolute() &&
                              (folder / relative).lexically_normal() != file.lexically_normal();
  return (leadsElsewhere ? file : relative).generic_string();
}

nlohmann::ordered_json SceneToolJson(const TouchToolSettings& tool,
                                     const std::filesystem::path& folder)
{
  nlohmann::ordered_json object{
      {"shape", WordOf(ShapeWords, tool.Kind)},
      {"radius_mm", tool.Radius},
      {"length_mm", tool.Length},
      {"semi_axes_mm", {tool.SemiAxes[0], tool.SemiAxes[1], tool.SemiAxes[2]}},
      {"points", tool.Points}};
  if (!tool.File.empty())
  {
    object["file"] = RelativeFile(tool.File, folder);
  }
  return object;
}
} // namespace palpate
