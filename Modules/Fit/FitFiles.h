#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"
#include "ReportIndex.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Writes what a fit found into `folder`, which is made where it is missing: model.json and
/// model.csv (coefficients), model.vtp (the model's surface with its arrays), surface.vtp (the
/// structure's own surface) and report.html. A structure that was not fitted gets only what there
/// is; what an earlier fit left under the other names is removed. All files are written, or none:
/// after a failure the folder holds what it held before. `program` is the maker that the
/// coefficient files name. Throws InputError.
PALPATEFIT_EXPORT void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                                     const std::filesystem::path& folder,
                                     const std::string& program);

/// Writes the overview of many cases as report.html. Where the folder had the report of an earlier
/// fit, its model and surface are removed. Throws InputError.
PALPATEFIT_EXPORT void WriteFitOverview(const ReportIndex& index,
                                        const std::filesystem::path& folder);
} // namespace palpate
