#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The structure's name, or "Label 3" if it has none. Not escaped.
PALPATEFIT_EXPORT std::string StructureText(const FitResult& result);

/// A message about a file for a page that may be shared: the file's path is reduced to its name.
/// Not escaped.
PALPATEFIT_EXPORT std::string SharedText(const std::filesystem::path& file, std::string message);

/// The verdict in one or two sentences: the result's message, or the quality of the fit. Not
/// escaped.
PALPATEFIT_EXPORT std::string VerdictText(const FitResult& result);
} // namespace palpate
