#pragma once

#include "PalpateTaskModule.h"
#include "TaskResults.h"

#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// Share of simulated studies that find a difference.
struct StudyPower
{
  int Participants = 0;
  int Studies = 0;
  int Found = 0;
  double Low = 0.0; ///< of the 95 % interval of Clopper and Pearson, for the number of studies
  double High = 1.0;
};

/// Comparison of two conditions by the participants' means of the primary measure.
struct TaskComparison
{
  std::string Measure;
  std::string First; ///< condition
  std::string Second;
  double FirstMean = 0.0;
  double SecondMean = 0.0;
  int Participants = 0;             ///< with trials of both
  double Difference = 0.0;          ///< second minus first, mean over participants
  double DifferenceDeviation = 0.0; ///< standard deviation between participants
  double PValue = 1.0;              ///< paired t-test, two-sided
  std::vector<StudyPower> Powers;   ///< by number of participants; empty for fewer than two
  /// The least number of them from which on the interval lies above Wanted; 0: none.
  int Sufficient = 0;
  static constexpr double Wanted = 0.8;
  static constexpr double Significance = 0.05;
};

/// Compares the first two conditions, training left out. The power of a study of n participants is
/// that of n drawn with replacement from those that there are: it is as good as their number, which
/// the intervals do not know. Equal seeds give equal results. Without a second condition, or
/// participants that did both, there are no powers.
PALPATETASK_EXPORT TaskComparison CompareConditions(const TaskResults& results, int studies,
                                                    std::uint64_t seed);

/// The exact interval of a binomial proportion, Clopper and Pearson, Biometrika 26 (1934) 404-413.
PALPATETASK_EXPORT StudyPower BinomialInterval(int participants, int studies, int found);
} // namespace palpate
