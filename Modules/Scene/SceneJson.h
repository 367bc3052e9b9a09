#pragma once

#include "JsonFields.h"
#include "PalpateSceneModule.h"
#include "SceneSettings.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace palpate
{
/// Reads the entries of a scene from an object of a scene file or a session: "structures", "fit",
/// "tool", "drill", "device", "rate_hz", "model_interval", "placement". The name of every number
/// ends with its unit; entries that are missing keep their defaults; paths are relative to
/// `folder`. `fields` are those of `object`, `file` is for messages. Throws InputError.
PALPATESCENE_EXPORT SceneSettings ReadSceneJson(const nlohmann::json& object, JsonFields& fields,
                                                const std::filesystem::path& folder,
                                                const std::filesystem::path& file);

/// Adds the same entries, all of them written out.
PALPATESCENE_EXPORT void AddSceneJson(nlohmann::ordered_json& object, const SceneSettings& scene,
                                      const std::filesystem::path& folder);
} // namespace palpate
