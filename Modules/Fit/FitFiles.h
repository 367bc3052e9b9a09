#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"
#include "ReportIndex.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Writes the result of a fit into `folder`, which is created if needed: model.json and model.csv
/// (coefficients), model.vtp (the model's surface with its arrays), surface.vtp (the structure's
/// own surface) and report.html. A structure that was not fitted gets only the available files; an
/// earlier fit's files of the other names are removed. All files are written, or none: after a
/// failure the folder is unchanged. `program` is the program name in the coefficient files. Throws
/// InputError.
PALPATEFIT_EXPORT void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                                     const std::filesystem::path& folder,
                                     const std::string& program);

/// Writes the overview of many cases as report.html. If the folder has the report of an earlier
/// fit, its model and surface are removed. Throws InputError.
PALPATEFIT_EXPORT void WriteFitOverview(const ReportIndex& index,
                                        const std::filesystem::path& folder);
} // namespace palpate
