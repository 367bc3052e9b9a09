#pragma once

#include "OrganRelations.h"
#include "PalpateComparisonModule.h"

#include <filesystem>

namespace palpate
{
/// Writes report.html, organs.csv, pairs.csv, relations.json and a surface with its maps for each
/// organ (surfaces/NAME.vtp), all or none of the first four, under AtomicFile's rules. Throws
/// InputError.
PALPATECOMPARISON_EXPORT void WriteRelationFiles(const OrganRelations& relations,
                                                 const std::filesystem::path& folder);
} // namespace palpate
