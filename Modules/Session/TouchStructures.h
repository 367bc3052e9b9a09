#pragma once

#include "PalpateSessionModule.h"
#include "Progress.h"
#include "TouchContact.h"
#include "TouchScene.h"
#include "TouchSettings.h"

#include <string>
#include <vector>

namespace palpate
{
/// A structure ready to be touched, and what it took.
struct TouchableStructure
{
  TouchStructure Touch;
  TouchAppearance Looks;
  std::string Represented; ///< in words, such as "harmonics of degree 12, nearest point"
  double Seconds = 0.0;    ///< to make
  std::vector<std::string> Notes;
};

/// Reads the files and makes the models, each only as the settings ask. Throws InputError,
/// FilterError and Cancelled.
PALPATESESSION_EXPORT std::vector<TouchableStructure>
MakeTouchStructures(const TouchSettings& settings, const ProgressFunction& progress);

/// The tool of the settings. Throws InputError for one that is none.
PALPATESESSION_EXPORT ToolShape MakeTool(const TouchToolSettings& settings);
} // namespace palpate
