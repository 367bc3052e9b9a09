#pragma once

#include "MaskChecks.h"
#include "PalpateComparisonModule.h"

#include <filesystem>

namespace palpate
{
/// Writes report.html, structures.csv and check.json, all or none, under AtomicFile's rules. Throws
/// InputError.
PALPATECOMPARISON_EXPORT void WriteCheckFiles(const MaskChecks& checks,
                                              const std::filesystem::path& folder);
} // namespace palpate
