#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <filesystem>
#include <string>

namespace palpate
{
struct OutcomeText
{
  std::string Word;  ///< in JSON and tables: "fitted", "refused", "bad-input" or "failed"
  std::string Title; ///< on pages: "Fitted", ...
  std::string Style; ///< the style sheet's class for its colour: "good", "poor" or "bad"
};
PALPATEFIT_EXPORT OutcomeText TextOf(FitResult::Outcome outcome);

/// "good", "gaps" or "undetermined": how well the directions determine a fit.
PALPATEFIT_EXPORT std::string CoverageWord(const DirectionCoverage& coverage);

/// "folder/mask.nii.gz, label 1 (Prostate)": a structure's name for output lines and errors.
PALPATEFIT_EXPORT std::string CaseTitle(const std::filesystem::path& input,
                                        const Segment& structure);

/// A case and its message, in one sentence. A message that is a predicate ("is not star-shaped")
/// follows its subject, a full clause follows a colon, and a message that starts with the file's
/// path, or concerns a file without a structure, stands alone.
PALPATEFIT_EXPORT std::string CaseMessage(const std::filesystem::path& input,
                                          const Segment& structure, const std::string& message);
} // namespace palpate
