#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Writes pairs as a table (CSV, a row each) for statistics packages. The columns' names have their
/// units; numbers that do not exist are empty. Throws InputError.
PALPATECOMPARISON_EXPORT void WriteComparisonTable(const std::vector<PairComparison>& pairs,
                                                   const std::vector<double>& tolerances,
                                                   const std::filesystem::path& file);
} // namespace palpate
