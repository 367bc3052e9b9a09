#pragma once

#include "PalpateStudyModule.h"

#include <filesystem>

namespace palpate
{
/// What a file that somebody gives without a word is to a study.
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

/// By its name, or else by what is in it, as `palpate info` tells it. Reads the whole file. Throws
/// InputError.
PALPATESTUDY_EXPORT StudyFileRole RoleOf(const std::filesystem::path& file);
} // namespace palpate
