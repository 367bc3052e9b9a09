#pragma once

#include "OrganRelations.h"
#include "PalpateComparisonModule.h"

#include <filesystem>

namespace palpate
{
/// Writes report.html, organs.csv, pairs.csv, relations.json and a surface with its maps for each
/// organ (surfaces/NAME.vtp; its distances from each near one as "DistanceTo_" and the name of that
/// one's file), all or none of the first four, under AtomicFile's rules; of tubes, if they are
/// measured, their axes (calibre/NAME.vtp) and sections (calibre/NAME.csv). Throws InputError.
PALPATECOMPARISON_EXPORT void WriteRelationFiles(const OrganRelations& relations,
                                                 const std::filesystem::path& folder);
} // namespace palpate
