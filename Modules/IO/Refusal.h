#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Throws InputError with the one sentence "<file> <fact>; <way out>.".
[[noreturn]] PALPATEIO_EXPORT void Refuse(const std::filesystem::path& file,
                                          const std::string& fact, const std::string& wayOut);

/// A number for a sentence: six significant digits, no trailing zeros.
PALPATEIO_EXPORT std::string NumberText(double value);
} // namespace palpate
