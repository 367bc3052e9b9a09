#pragma once

#include "PalpateSceneModule.h"
#include "SceneSettings.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Whether a file is a scene by its name: scene.json, or one that ends with .scene.json. A model is
/// JSON too.
PALPATESCENE_EXPORT bool IsSceneFile(const std::filesystem::path& path);

/// Reads a scene: "format": "palpate-scene" and the entries of ReadSceneJson, with paths relative
/// to the file. Refuses settings that contradict each other. Throws InputError.
PALPATESCENE_EXPORT SceneSettings ReadScene(const std::filesystem::path& path);

/// The same as text, all entries written out, paths relative to the folder.
PALPATESCENE_EXPORT std::string SceneText(const SceneSettings& scene,
                                          const std::filesystem::path& folder);
} // namespace palpate
