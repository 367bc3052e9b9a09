#include "InstructionCounts.h"

#include <cstdlib>
#include <fstream>
#include <valgrind/callgrind.h>

namespace palpate::bench
{
namespace
{
void CountOne(const std::string& name, const std::function<void()>& run)
{
  run();
  CALLGRIND_ZERO_STATS;
  CALLGRIND_START_INSTRUMENTATION;
  run();
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

std::string After(const std::string& line, const std::string& start)
{
  return line.rfind(start, 0) == 0 ? line.substr(start.size()) : std::string();
}
} // namespace

InstructionCounts::InstructionCounts(const std::filesystem::path& folder)
{
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
  {
    std::ifstream file(entry.path());
    std::string name;
    std::string total;
    for (std::string line; std::getline(file, line);)
    {
      const std::string trigger = After(line, "desc: Trigger: Client Request: ");
      const std::string count = After(line, "totals: ");
      name = trigger.empty() ? name : trigger;
      total = count.empty() ? total : count;
    }
    if (!name.empty() && !total.empty())
    {
      this->Counts[name] = std::strtod(total.c_str(), nullptr);
    }
  }
}

std::optional<double> InstructionCounts::Of(const std::string& name) const
{
  const auto found = this->Counts.find(name);
  return found != this->Counts.end() ? std::optional<double>(found->second) : std::nullopt;
}

bool InstructionCounts::Count(const std::vector<PairedBenchmark>& pairs)
{
  if (RUNNING_ON_VALGRIND == 0)
  {
    return false;
  }
  for (const PairedBenchmark& pair : pairs)
  {
    if (pair.IsCounted)
    {
      CountOne(pair.Name, pair.Run);
      CountOne(pair.AlternativeName(), pair.RunAgainst);
    }
  }
  return true;
}
} // namespace palpate::bench
