#pragma once

#include "CohortTable.h"
#include "FitSettings.h"
#include "PalpateGroupModule.h"
#include "Progress.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Fits one structure of every mask of a folder (FindMasks): the first one of the first mask that
/// can be read, which the others have under the same label. Writes a cohort.csv and the models
/// alone into `output`, which is created; a mask that cannot be fitted is a row with the reason.
/// `program` is named in the models. Throws InputError without masks, or if `output` cannot be
/// written, and Cancelled.
PALPATEGROUP_EXPORT CohortTable FitMaskFolder(const std::filesystem::path& masks,
                                              const std::filesystem::path& output,
                                              const FitSettings& settings,
                                              const std::string& program,
                                              const ProgressFunction& progress = {});
} // namespace palpate
