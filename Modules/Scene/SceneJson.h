#pragma once

#include "JsonFields.h"
#include "PalpateSceneModule.h"
#include "SceneSettings.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace palpate
{
/// Reads the entries of a scene from an object of a scene file or a session: "structures", "fit",
/// "tool", "drill", "device", "rate_hz", "model_interval", "placement". Names of numbers end with
/// the unit; missing entries keep their defaults; paths are relative to `folder`. `fields` are
/// those of `object`, `file` is for messages. Throws InputError.
PALPATESCENE_EXPORT SceneSettings ReadSceneJson(const nlohmann::json& object, JsonFields& fields,
                                                const std::filesystem::path& folder,
                                                const std::filesystem::path& file);

/// Adds the same entries, including those with default values.
PALPATESCENE_EXPORT void AddSceneJson(nlohmann::ordered_json& object, const SceneSettings& scene,
                                      const std::filesystem::path& folder);
} // namespace palpate
