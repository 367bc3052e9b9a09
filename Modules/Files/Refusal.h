#pragma once

#include "Status.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Throws InputError with the message "<file> <fact>; <remedy>.", where the remedy says what to
/// do.
[[noreturn]] void Refuse(const std::filesystem::path& file, const std::string& fact,
                         const std::string& remedy);

/// Throws InputError with a failure's message, prefixed with "<about>: " unless that is empty. Does
/// nothing for a success.
void RequireInput(const Status& status, const std::string& about = {});
} // namespace palpate
