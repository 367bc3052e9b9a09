#pragma once

#include "Segmentation.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// "folder/mask.nii.gz, label 1 (Prostate)": a structure as lines and errors name it.
std::string CaseTitle(const std::filesystem::path& input, const Segment& structure);

/// A case and what happened to it, in one sentence. A message that is a predicate ("is not
/// star-shaped") follows its subject, a full clause follows a colon, and one that starts with the
/// file's path, or is of a file without a structure, stands alone.
std::string CaseSentence(const std::filesystem::path& input, const Segment& structure,
                         const std::string& message);
} // namespace palpate::cli
