#include "ComparisonReport.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

namespace palpate::bench
{
void PrintTable(std::ostream& out, const std::vector<Comparison>& comparisons)
{
  out << std::fixed << std::setprecision(3);
  for (const Comparison& c : comparisons)
  {
    out << c.Name << ": " << c.Nanoseconds / 1e6 << " ms; " << c.Against << ": "
        << c.AgainstNanoseconds / 1e6 << " ms; ratio " << c.Ratio() << '\n';
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
  }
  return list.dump(2);
}
} // namespace palpate::bench
