#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// An outcome in one or two words ("Fitted", "Refused", ...).
PALPATEFIT_EXPORT std::string OutcomeText(FitResult::Outcome outcome);

/// The class of the style sheet that colours an outcome: "good", "poor" or "bad".
PALPATEFIT_EXPORT std::string OutcomeStyle(FitResult::Outcome outcome);

/// The structure's name, or "Label 3" where it has none. Not escaped.
PALPATEFIT_EXPORT std::string StructureText(const FitResult& result);

/// A sentence about a file for a page that may be passed on: the file's path is cut to its name.
/// Not escaped.
PALPATEFIT_EXPORT std::string SharedText(const std::filesystem::path& file, std::string sentence);

/// The verdict in a sentence or two: the result's message, or what the fit reached. Not escaped.
PALPATEFIT_EXPORT std::string VerdictText(const FitResult& result);
} // namespace palpate
