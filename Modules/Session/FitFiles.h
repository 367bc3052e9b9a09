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
/// is; what an earlier fit left under the other names is removed. `program` is the maker that the
/// coefficient files name. Throws InputError.
PALPATESESSION_EXPORT void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                                         const std::filesystem::path& folder,
                                         const std::string& program);

/// Removes model and surface of an earlier fit from a folder that has a report.html of it; for a
/// folder whose report is going to be one of many cases. Throws InputError.
PALPATESESSION_EXPORT void RemoveEarlierFit(const std::filesystem::path& folder);

/// A text in letters that every file system takes, of at most 48 of them.
PALPATESESSION_EXPORT std::string PlainName(const std::string& text);

/// A folder name for one case of several: case, label and, if there is one, the structure's name,
/// in at most 80 letters that every file system takes. Structures of one case differ in it.
PALPATESESSION_EXPORT std::string CaseFolderName(const std::string& caseName,
                                                 const Segment& structure);
} // namespace palpate
