#pragma once

#include <string>
#include <vector>

namespace palpate
{
/// The scale on which the tail of a statistic is exponential.
enum class TailScale
{
  Logarithm, ///< ln(value + 0.005): shares of the volume, mostly 0
  Bounded,   ///< -ln(1.02 - value): shares that may reach 1
  Square     ///< value^2 / 2: in standard deviations
};

/// What is known of a statistic before any mask is seen.
struct CheckRule
{
  const char* Key; ///< of the statistic; of "end" and "edge" without the side
  ///@{ Without a group, from these values on. Infinite: not judged.
  double Look;
  double Implausible;
  ///@}
  /// With a group: the share of an organ's false alarms that it may take. All sum to 1. With 0,
  /// the rule states a fact, has the limits above with a group, too, and makes a case unfit for
  /// one.
  double Budget;
  ///@{ With a group, see TailProbability.
  TailScale Scale;
  double LeastTail;
  ///@}
};

/// All rules, those first whose sentence goes before others.
const std::vector<CheckRule>& CheckRules();

/// The rule of a statistic ("end_superior" has that of "end"); null if there is none.
const CheckRule* FindCheckRule(const std::string& key);

/// Its budget: "end" and "edge" share theirs between the sides.
double BudgetOf(const CheckRule& rule);
} // namespace palpate
