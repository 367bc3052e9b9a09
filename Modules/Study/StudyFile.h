#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// The ending of session files.
constexpr const char* StudyEnding = ".palpate.json";

/// A file that a state names and that is not there.
struct StudyMissingFile
{
  std::string Role; ///< "volume", "segmentation", "tool", "structure" or "texture"
  std::filesystem::path Path;
};

/// Writes a session file under AtomicFile's rules: paths relative to it, settings, placements,
/// landmarks; no text of an image's header. It is read back before it gets its name, so that what
/// is written opens exactly as it was. Throws InputError.
PALPATESTUDY_EXPORT void WriteStudy(const std::filesystem::path& path, const StudyState& state);

/// Reads one. Files that it names need not be there (see MissingFiles). Throws InputError.
PALPATESTUDY_EXPORT StudyState ReadStudy(const std::filesystem::path& path);

/// To be asked for.
PALPATESTUDY_EXPORT std::vector<StudyMissingFile> MissingFiles(const StudyState& state);

/// The state with `moved` in place of `missing`. What else is missing and lies where it did as seen
/// from the file that moved has moved along.
PALPATESTUDY_EXPORT StudyState Relocate(const StudyState& state,
                                        const std::filesystem::path& missing,
                                        const std::filesystem::path& moved);
} // namespace palpate
