#include "ComparisonReport.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

namespace palpate::bench
{
namespace
{
// Three or four digits in a suitable unit.
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

std::string CountText(const std::optional<double>& count)
{
  if (!count)
  {
    return "";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << *count << " instr.";
  return text.str();
}
} // namespace

void PrintTable(std::ostream& out, const std::vector<Comparison>& comparisons)
{
  for (const Comparison& c : comparisons)
  {
    out << std::left << std::setw(38) << c.Name << std::right << std::setw(10)
        << TimeText(c.Nanoseconds) << std::setw(18) << CountText(c.Instructions) << "  x "
        << std::fixed << std::setprecision(2) << std::setw(6) << c.Ratio() << "  against "
        << std::setw(10) << TimeText(c.AgainstNanoseconds) << std::setw(18)
        << CountText(c.AgainstInstructions) << "  " << c.Against << '\n';
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
    if (c.Instructions && c.AgainstInstructions)
    {
      list.back()["instructions"] = *c.Instructions;
      list.back()["against_instructions"] = *c.AgainstInstructions;
    }
  }
  return list.dump(2);
}
} // namespace palpate::bench
