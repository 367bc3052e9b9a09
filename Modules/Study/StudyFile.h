#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The ending of session files.
constexpr const char* StudyEnding = ".palpate.json";

/// A missing file that a state names.
struct StudyMissingFile
{
  std::string Role; ///< "volume", "segmentation", "tool", "prior", "transform", "structure" or an
                    ///< image's key
  std::filesystem::path Path;
};

/// Writes a session file under AtomicFile's rules: relative paths, settings, placements, landmarks;
/// no text from image headers. The text is read back and compared before it is written, so the file
/// opens exactly as saved. `drilled` is the file with what was drilled; may be empty. Throws
/// InputError.
PALPATESTUDY_EXPORT void WriteStudy(const std::filesystem::path& path, const StudyState& state,
                                    const std::filesystem::path& drilled = {});

/// Reads a session file. Files that it names may be missing (see MissingFiles). `drilled` receives
/// the file with what was drilled; empty if the session names none. Throws InputError.
PALPATESTUDY_EXPORT StudyState ReadStudy(const std::filesystem::path& path,
                                         std::filesystem::path* drilled = nullptr);

/// Files that the user has to locate.
PALPATESTUDY_EXPORT std::vector<StudyMissingFile> MissingFiles(const StudyState& state);

/// The state with `moved` in place of `missing`. Other missing files that exist at the same
/// relative location from `moved` are relocated too.
PALPATESTUDY_EXPORT StudyState Relocate(const StudyState& state,
                                        const std::filesystem::path& missing,
                                        const std::filesystem::path& moved);

/// Role of a file that is given to a study without further information.
enum class StudyFileRole
{
  Session, ///< a study itself
  Segmentation,
  Volume,
  Recording, ///< a recorded touch
  Markups,   ///< landmarks and measurements
  Scene,
  Model,
  Surface
};

/// The role of a session, scene, model, surface or markups file, which only its name tells; none
/// for images and recordings. Does not open the file.
PALPATESTUDY_EXPORT std::optional<StudyFileRole> RoleByName(const std::filesystem::path& file);

/// Determined by its name, otherwise by its content, as in `palpate info`. Reads the whole file.
/// Throws InputError.
PALPATESTUDY_EXPORT StudyFileRole RoleOf(const std::filesystem::path& file);
} // namespace palpate
