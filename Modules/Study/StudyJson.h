#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A state as the text of a session file: "format": "palpate-study", "version": 2; every number's
/// name ends with its unit. Paths are relative to `folder`. Throws InputError, about `file`, for
/// names that are no UTF-8.
PALPATESTUDY_EXPORT std::string StudyText(const StudyState& state,
                                          const std::filesystem::path& folder,
                                          const std::filesystem::path& file);

/// The state of such a text. Entries that are missing keep their defaults. Throws InputError that
/// names `file` and the place: line and column of what is no JSON, otherwise the entry.
PALPATESTUDY_EXPORT StudyState StudyFromText(const std::string& text,
                                             const std::filesystem::path& folder,
                                             const std::filesystem::path& file);
} // namespace palpate
