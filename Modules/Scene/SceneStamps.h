#pragma once

#include "PalpateSceneModule.h"

#include <filesystem>
#include <map>
#include <string>

namespace palpate
{
/// The state of a scene's files: another text where one was written again.
using SceneStamps = std::map<std::filesystem::path, std::string>;

/// By the time and size of a file and of those that are read with it. Reads no file.
PALPATESCENE_EXPORT std::string StampOf(const std::filesystem::path& file);
} // namespace palpate
