#pragma once

#include "FitSettings.h"
#include "PalpateSessionModule.h"

#include <string>

namespace palpate
{
/// What to try where a structure is refused or fails, by the command line's options; nothing that
/// the settings already are.

/// Where the centre does not see enough of the surface.
PALPATESESSION_EXPORT std::string HintForHidden(const FitSettings& settings);
/// Where a model overlaps the mask too little.
PALPATESESSION_EXPORT std::string HintForMisfit(const FitSettings& settings);
/// Where a model cannot be the structure's.
PALPATESESSION_EXPORT std::string HintForImplausible(const FitSettings& settings);
/// The options that decide whether samples determine a model, between brackets.
PALPATESESSION_EXPORT std::string OptionsOfFit(const FitSettings& settings);
} // namespace palpate
