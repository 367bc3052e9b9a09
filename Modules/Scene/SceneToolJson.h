#pragma once

#include "PalpateSceneModule.h"
#include "SceneSettings.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace palpate
{
/// The entry "tool" of scenes and sessions: "shape", "radius_mm", "length_mm", "semi_axes_mm",
/// "points", "file" (from `folder`). `file` is for messages. Throws InputError.
PALPATESCENE_EXPORT TouchToolSettings ReadSceneTool(const nlohmann::json& object,
                                                    const std::filesystem::path& folder,
                                                    const std::filesystem::path& file);
/// The path of a file as written in a scene or session in `folder`: relative, or unchanged if a
/// relative path would lead elsewhere.
PALPATESCENE_EXPORT std::string RelativeFile(const std::filesystem::path& file,
                                             const std::filesystem::path& folder);
PALPATESCENE_EXPORT nlohmann::ordered_json SceneToolJson(const TouchToolSettings& tool,
                                                         const std::filesystem::path& folder);
} // namespace palpate
