#pragma once

#include "FitResult.h"
#include "PalpateSessionModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Writes what a fit found into `folder`, which is made where it is missing: model.json and
/// model.csv (coefficients), model.vtp (the model's surface with its arrays), surface.vtp (the
/// structure's own surface) and report.html. A structure that was not fitted gets only what there
/// is. `program` is the maker that the coefficient files name. Throws InputError.
PALPATESESSION_EXPORT void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                                         const std::filesystem::path& folder,
                                         const std::string& program);

/// A folder name for one case of several: case, label and, if there is one, the structure's name,
/// in letters that every file system takes.
PALPATESESSION_EXPORT std::string CaseFolderName(const FitResult& result);
} // namespace palpate
