#pragma once

#include "PalpateSceneModule.h"
#include "SceneSettings.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Whether a file is a scene by its name: scene.json, or ending with .scene.json, since models are
/// JSON files too.
PALPATESCENE_EXPORT bool IsSceneFile(const std::filesystem::path& path);

/// Reads a scene: "format": "palpate-scene" and the entries of ExchangeScene, with paths relative
/// to the file. `patch`, unless it is empty, changes the file's entries before: a JSON Patch (RFC
/// 6902), whose paths are relative to the scene too. Throws InputError, also for settings that
/// contradict each other.
PALPATESCENE_EXPORT SceneSettings ReadScene(const std::filesystem::path& path,
                                            const std::filesystem::path& patch = {});

/// A scene as the text of a scene file: all entries, paths relative to the folder.
PALPATESCENE_EXPORT std::string SceneText(SceneSettings scene, const std::filesystem::path& folder);
} // namespace palpate
