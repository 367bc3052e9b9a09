#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// Mean, median and extremes of a number over pairs.
struct PALPATECOMPARISON_EXPORT NumberSummary
{
  std::size_t Count = 0; ///< of those that are finite
  double Mean = 0.0;     ///< NaN without any, as the others
  double Median = 0.0;
  double Least = 0.0;
  double Largest = 0.0;

  static NumberSummary Of(std::vector<double> numbers);
};

/// What is summarised of the pairs of a folder: name, unit, digits, and the number of each pair
/// that was compared.
struct SummarisedNumber
{
  std::string Name;
  std::string Unit;
  int Digits = 0;
  NumberSummary Summary;
};
PALPATECOMPARISON_EXPORT std::vector<SummarisedNumber>
SummariseComparisons(const std::vector<PairComparison>& pairs);

/// A page on the pairs of a folder: a summary, a row for each with a link to its own page in the
/// folder of its name (PairFolder), and what was not compared.
PALPATECOMPARISON_EXPORT std::string ComparisonOverview(const std::vector<PairComparison>& pairs,
                                                        const std::vector<std::string>& unpaired);
} // namespace palpate
