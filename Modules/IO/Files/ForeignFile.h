#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Throws InputError with the format of the file's content or name if it is one that is known but
/// not read, such as a web page or an archive; otherwise with this fact and fix.
[[noreturn]] PALPATEIO_EXPORT void RefuseContent(const std::filesystem::path& file,
                                                 const std::string& fact,
                                                 const std::string& remedy);
} // namespace palpate
