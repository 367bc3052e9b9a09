#pragma once

#include "PalpateIOModule.h"
#include "Status.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Throws InputError with the one sentence "<file> <fact>; <way out>.".
[[noreturn]] PALPATEIO_EXPORT void Refuse(const std::filesystem::path& file,
                                          const std::string& fact, const std::string& wayOut);

/// Throws InputError with a failure's sentence, after what it is about ("<about>: <sentence>")
/// unless that is empty. Nothing for a success.
PALPATEIO_EXPORT void RequireInput(const Status& status, const std::string& about = {});
} // namespace palpate
