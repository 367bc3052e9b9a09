#pragma once

#include "PairComparison.h"

#include <string>
#include <vector>

namespace palpate::cli
{
/// A pair as a table of some lines.
std::string ComparisonText(const PairComparison& pair);
/// A pair of many as one line.
std::string ComparisonLine(const PairComparison& pair);
/// Mean, median and extremes over pairs; empty without any that was compared.
std::string SummaryText(const std::vector<PairComparison>& pairs);
} // namespace palpate::cli
