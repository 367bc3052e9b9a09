#pragma once

#include "PalpateSessionModule.h"
#include "StudyState.h"

#include <string>

namespace palpate
{
/// How the files of a state are now: another text where one was written again.
struct StudyStamps
{
  std::string Volume;
  std::string Segmentation;
  std::string Tool; ///< empty where the tool is not from a file
};

/// By the time and size of each file and of those that are read with it. Reads no file.
PALPATESESSION_EXPORT StudyStamps StampFiles(const StudyState& state);
} // namespace palpate
