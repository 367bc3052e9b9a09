#pragma once

#include "FitSettings.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// What to try where a structure is refused or fails, by the options of `palpate fit`; nothing that
/// the settings already are.

/// Where the centre does not see enough of the surface.
PALPATEFIT_EXPORT std::string HintForHidden(const FitSettings& settings);
/// Where a model overlaps the mask too little.
PALPATEFIT_EXPORT std::string HintForMisfit(const FitSettings& settings);
/// Where a model cannot be the structure's.
PALPATEFIT_EXPORT std::string HintForImplausible(const FitSettings& settings);
/// The options that decide whether samples determine a model, between brackets.
PALPATEFIT_EXPORT std::string OptionsOfFit(const FitSettings& settings);
/// Where a structure has too few voxels; `palpate mesh` has these options too.
PALPATEFIT_EXPORT std::string HintForTooFewVoxels();

/// The same by the controls of the window, and what a session file says of them.
PALPATEFIT_EXPORT std::string WindowHintForHidden(const FitSettings& settings);
PALPATEFIT_EXPORT std::string WindowHintForMisfit(const FitSettings& settings);
PALPATEFIT_EXPORT std::string WindowHintForImplausible(const FitSettings& settings);

/// A reason and what to try, as one sentence; the reason alone for an empty hint.
PALPATEFIT_EXPORT std::string WithHint(const std::string& reason, const std::string& hint);
} // namespace palpate
