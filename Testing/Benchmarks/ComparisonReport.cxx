#include "ComparisonReport.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

namespace palpate::bench
{
namespace
{
// Three or four figures in the unit that suits them.
std::string TimeText(double nanoseconds)
{
  std::ostringstream text;
  text << std::fixed;
  if (nanoseconds < 1e4)
  {
    text << std::setprecision(1) << nanoseconds << " ns";
  }
  else if (nanoseconds < 1e7)
  {
    text << std::setprecision(1) << nanoseconds / 1e3 << " us";
  }
  else
  {
    text << std::setprecision(1) << nanoseconds / 1e6 << " ms";
  }
  return text.str();
}
} // namespace

void PrintTable(std::ostream& out, const std::vector<Comparison>& comparisons)
{
  for (const Comparison& c : comparisons)
  {
    out << std::left << std::setw(44) << c.Name << std::right << std::setw(10)
        << TimeText(c.Nanoseconds) << "  x " << std::fixed << std::setprecision(2) << std::setw(6)
        << c.Ratio() << "  against " << std::setw(10) << TimeText(c.AgainstNanoseconds);
    if (c.Instructions > 0.0)
    {
      out << std::setprecision(0) << "  instructions " << std::setw(10) << c.Instructions
          << " against " << std::setw(10) << c.AgainstInstructions;
    }
    out << "  " << c.Against << '\n';
  }
}

std::string ToJson(const std::vector<Comparison>& comparisons)
{
  nlohmann::json list = nlohmann::json::array();
  for (const Comparison& c : comparisons)
  {
    list.push_back({{"name", c.Name},
                    {"ns", c.Nanoseconds},
                    {"against", c.Against},
                    {"against_ns", c.AgainstNanoseconds},
                    {"ratio", c.Ratio()}});
    if (c.Instructions > 0.0)
    {
      list.back()["instructions"] = c.Instructions;
      list.back()["against_instructions"] = c.AgainstInstructions;
    }
  }
  return list.dump(2);
}
} // namespace palpate::bench
