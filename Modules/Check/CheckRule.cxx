#include "CheckRule.h"

#include <limits>
#include <string_view>

namespace palpate
{
namespace
{
constexpr double Never = std::numeric_limits<double>::infinity();
// Of keys with a side: how many there are; 1 of others.
double SidesOf(std::string_view key)
{
  return key == "end" ? 2.0 : key == "edge" ? 4.0 : 1.0;
}
} // namespace

const std::vector<CheckRule>& CheckRules()
{
  using Scale = TailScale;
  static const std::vector<CheckRule> rules{
      {"side", 1.0, 1.0, 0.0, Scale::Logarithm, 1.0},
      {"border", 0.02, Never, 0.0, Scale::Logarithm, 0.2},
      {"gap", 0.05, 0.3, 0.02, Scale::Logarithm, 0.1},
      {"part", 0.005, 0.04, 0.02, Scale::Logarithm, 0.1},
      {"hole", 0.002, 0.02, 0.015, Scale::Logarithm, 0.1},
      {"overlap", 0.05, 0.2, 0.002, Scale::Logarithm, 0.2},
      {"pair", 0.5, 1.0, 0.002, Scale::Logarithm, 0.1},
      {"neck", 0.7, 0.9, 0.06, Scale::Bounded, 0.25},
      {"copied", 0.4, 0.6, 0.02, Scale::Bounded, 0.05},
      {"end", 0.6, Never, 0.662, Scale::Bounded, 0.05},
      {"edge", 0.6, Never, 0.002, Scale::Bounded, 0.05},
      {"shape", Never, Never, 0.16, Scale::Square, 1.0},
      {"band_2", Never, Never, 0.002, Scale::Square, 0.3},
      {"band_3_5", Never, Never, 0.002, Scale::Square, 0.3},
      {"band_6_12", Never, Never, 0.002, Scale::Square, 0.3},
      {"rough", Never, Never, 0.01, Scale::Logarithm, 0.1},
      {"step", Never, Never, 0.001, Scale::Logarithm, 0.1},
      {"slice_hole", 0.05, Never, 0.015, Scale::Logarithm, 0.2},
      {"size", Never, Never, 0.003, Scale::Square, 0.5},
      {"position", Never, Never, 0.002, Scale::Square, 0.5}};
  return rules;
}

const CheckRule* FindCheckRule(const std::string& key)
{
  for (const CheckRule& rule : CheckRules())
  {
    const std::string_view name = rule.Key;
    if (key == name || (SidesOf(name) > 1.0 && key.rfind(std::string(name) + "_", 0) == 0))
    {
      return &rule;
    }
  }
  return nullptr;
}

double BudgetOf(const CheckRule& rule)
{
  return rule.Budget / SidesOf(rule.Key);
}
} // namespace palpate
