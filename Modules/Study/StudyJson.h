#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A state as the text of a session file: "format": "palpate-study", "version": 2; names of numbers
/// end with the unit. Paths are relative to `folder`. `drilled` names the file with what was
/// drilled; may be empty. Throws InputError, naming `file`, for names that are not UTF-8.
PALPATESTUDY_EXPORT std::string StudyText(StudyState state, const std::filesystem::path& folder,
                                          const std::filesystem::path& file,
                                          std::filesystem::path drilled = {});

/// Reads a state from such a text. Missing entries keep their defaults. Throws InputError that
/// names `file` and the position: line and column for invalid JSON, otherwise the entry.
PALPATESTUDY_EXPORT StudyState StudyFromText(const std::string& text,
                                             const std::filesystem::path& folder,
                                             const std::filesystem::path& file,
                                             std::filesystem::path* drilled = nullptr);
} // namespace palpate
