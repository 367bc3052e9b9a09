#pragma once

#include "PalpateSceneModule.h"

#include <filesystem>
#include <map>
#include <string>

namespace palpate
{
/// Stamps of a scene's files; a file's stamp changes when it is written again.
using SceneStamps = std::map<std::filesystem::path, std::string>;

/// Made of the modification time and size of a file and of its companion files. Reads no file
/// content.
PALPATESCENE_EXPORT std::string StampOf(const std::filesystem::path& file);
} // namespace palpate
