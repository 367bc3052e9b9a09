#pragma once

#include "PalpateSessionModule.h"
#include "TouchSettings.h"

#include <filesystem>

namespace palpate
{
/// Whether a file is a scene by its name: scene.json, or one that ends with .scene.json. A model is
/// JSON too.
PALPATESESSION_EXPORT bool IsTouchSceneFile(const std::filesystem::path& path);

/// Reads a scene to touch from JSON: "format": "palpate-scene", "structures", "tool", "device",
/// "rate_hz", "model_interval", "scale"; every number's name ends with its unit. Paths are relative
/// to the file. Throws InputError.
PALPATESESSION_EXPORT TouchSettings ReadTouchScene(const std::filesystem::path& path);

/// The same as text, all entries written out, paths relative to the folder.
PALPATESESSION_EXPORT std::string TouchSceneText(const TouchSettings& settings,
                                                 const std::filesystem::path& folder);
} // namespace palpate
