#pragma once

#include "PalpateStudyModule.h"

#include <filesystem>

namespace palpate
{
/// Role of a file that is given to a study without further information.
enum class StudyFileRole
{
  Session, ///< a study itself
  Segmentation,
  Volume,
  Recording, ///< a recorded touch
  Scene,
  Model,
  Surface
};

/// Determined by its name, otherwise by its content, as in `palpate info`. Reads the whole file.
/// Throws InputError.
PALPATESTUDY_EXPORT StudyFileRole RoleOf(const std::filesystem::path& file);
} // namespace palpate
