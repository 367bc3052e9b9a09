#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Made of the modification time and size of a file and of its companion files: it changes when one
/// of them is written again. Of a folder, of all its files. Reads no file content.
PALPATEIO_EXPORT std::string StampOf(const std::filesystem::path& file);
} // namespace palpate
