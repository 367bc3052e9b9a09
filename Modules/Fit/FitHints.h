#pragma once

#include "FitSettings.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// What suggestions call the settings of a fit.
struct HintWords
{
  const char* Degree;
  const char* MaximumDegree; ///< the degree if it is searched for
  const char* Frequency;
  const char* VisibleCenter;
  const char* MaximumHidden;
  const char* MinimumDice;
  const char* OrganModel;
  const char* Repair;
  const char* EachPart;
  const char* Penalty; ///< empty if none is suggested
  const char* Part;    ///< of a surface file; empty if none can be chosen
};
/// As options of `palpate fit`.
inline constexpr HintWords OptionWords{
    "another --degree", "another --max-degree", "a higher --frequency", "--center visible",
    "--max-hidden",     "--min-dice",           "--model surface",      "--repair",
    "--component each", "--penalty auto",       "--component"};
/// As controls of the window, also used for session files.
inline constexpr HintWords WindowWords{"another degree",
                                       "another degree",
                                       "a higher Frequency",
                                       "the most visible Centre",
                                       "Maximum hidden",
                                       "Minimum Dice",
                                       "the Model surface",
                                       "Repair",
                                       "another Component",
                                       "",
                                       ""};

/// Suggestions for a structure that is refused; settings that are already in use are not suggested.
using Hint = std::string(const FitSettings& settings, const HintWords& words);
/// If the centre does not see enough of the surface.
PALPATEFIT_EXPORT Hint HintForHidden;
/// If a model overlaps the mask too little.
PALPATEFIT_EXPORT Hint HintForMisfit;
/// If a model crosses itself or misses a tolerance.
PALPATEFIT_EXPORT Hint HintForDegree;
/// If a repair of the topology would change too much.
PALPATEFIT_EXPORT Hint HintForRepair;
/// If parts that are too far apart cannot be modelled as one.
PALPATEFIT_EXPORT Hint HintForEachPart;
/// If a structure has parts that a model would leave out or join from afar.
PALPATEFIT_EXPORT Hint HintForParts;
/// If a surface from a file cannot be mended.
PALPATEFIT_EXPORT Hint HintForOpenSurface;
/// If a model cannot be the structure's.
PALPATEFIT_EXPORT Hint HintForImplausible;

/// The options that affect whether samples determine a model, in brackets.
PALPATEFIT_EXPORT std::string OptionsOfFit(const FitSettings& settings);
/// If a structure has too few voxels; `palpate mesh` has these options too.
PALPATEFIT_EXPORT std::string HintForTooFewVoxels();
/// If no setting helps; the window touches such a structure by its voxels or triangles anyway.
PALPATEFIT_EXPORT std::string HintForShape();

/// A reason and a hint, as one sentence; the reason alone for an empty hint.
PALPATEFIT_EXPORT std::string WithHint(const std::string& reason, const std::string& hint);
} // namespace palpate
