#pragma once

#include "PalpateIOModule.h"
#include "Status.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Throws InputError with the message "<file> <fact>; <remedy>.", where the remedy says what to
/// do.
[[noreturn]] PALPATEIO_EXPORT void Refuse(const std::filesystem::path& file,
                                          const std::string& fact, const std::string& remedy);

/// Throws InputError with a failure's message, prefixed with "<about>: " unless that is empty. Does
/// nothing for a success.
PALPATEIO_EXPORT void RequireInput(const Status& status, const std::string& about = {});
} // namespace palpate
