#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/// Pairs as a table (CSV, a row each) for statistics packages. The columns' names have their units;
/// numbers that do not exist are empty.
PALPATECOMPARISON_EXPORT std::string ComparisonTable(const std::vector<PairComparison>& pairs,
                                                     const std::vector<double>& tolerances);

/// The pairs of such a text, with the numbers that it has; none if it is a table of other
/// tolerances, or of a program whose tables have other columns.
PALPATECOMPARISON_EXPORT std::vector<PairComparison>
PairsInTable(std::string_view text, const std::vector<double>& tolerances);

/// Writes the table under AtomicFile's rules: an old one remains until it is replaced as a whole.
/// Throws InputError.
PALPATECOMPARISON_EXPORT void WriteComparisonTable(const std::vector<PairComparison>& pairs,
                                                   const std::vector<double>& tolerances,
                                                   const std::filesystem::path& file);

/// PairsInTable of a file; none if there is no such file. Throws InputError.
PALPATECOMPARISON_EXPORT std::vector<PairComparison>
ReadComparisonTable(const std::filesystem::path& file, const std::vector<double>& tolerances);
} // namespace palpate
