#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Writes a compared pair into `folder`, which is created if needed: first.vtp and reference.vtp
/// (the surfaces with their distances), map.png and report.html. All files, or none. The pair must
/// have its surfaces. Throws InputError.
PALPATECOMPARISON_EXPORT void WriteComparisonFiles(const PairComparison& pair,
                                                   const std::filesystem::path& folder);

/// Writes comparison.csv and report.html (ComparisonOverview) of several pairs. Throws InputError.
PALPATECOMPARISON_EXPORT void WriteComparisonOverview(const std::vector<PairComparison>& pairs,
                                                      const std::vector<std::string>& unpaired,
                                                      const std::vector<double>& tolerances,
                                                      const std::filesystem::path& folder);

/// A pair's folder among several: case and structure, relative.
PALPATECOMPARISON_EXPORT std::filesystem::path PairFolder(const PairComparison& pair);
} // namespace palpate
