#pragma once

#include "FitSettings.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// Suggestions for a structure that is refused or fails, as options of `palpate fit`; settings that
/// are already in use are not suggested.

/// If the centre does not see enough of the surface.
PALPATEFIT_EXPORT std::string HintForHidden(const FitSettings& settings);
/// If a model overlaps the mask too little.
PALPATEFIT_EXPORT std::string HintForMisfit(const FitSettings& settings);
/// If a model cannot be the structure's.
PALPATEFIT_EXPORT std::string HintForImplausible(const FitSettings& settings);
/// The options that affect whether samples determine a model, in brackets.
PALPATEFIT_EXPORT std::string OptionsOfFit(const FitSettings& settings);
/// If a structure has too few voxels; `palpate mesh` has these options too.
PALPATEFIT_EXPORT std::string HintForTooFewVoxels();

/// The same as controls of the window, also used for session files.
PALPATEFIT_EXPORT std::string WindowHintForHidden(const FitSettings& settings);
PALPATEFIT_EXPORT std::string WindowHintForMisfit(const FitSettings& settings);
PALPATEFIT_EXPORT std::string WindowHintForImplausible(const FitSettings& settings);

/// A reason and a hint, as one sentence; the reason alone for an empty hint.
PALPATEFIT_EXPORT std::string WithHint(const std::string& reason, const std::string& hint);
} // namespace palpate
