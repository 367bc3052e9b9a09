#include "InstructionCounts.h"

#include <filesystem>
#include <fstream>
#include <functional>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#endif

namespace palpate::bench
{
namespace
{
// Lines of callgrind's files that say what was counted, and how much.
const std::string Trigger = "desc: Trigger: Client Request: ";
const std::string Totals = "totals: ";
const std::string Ours = "ours ";
const std::string Against = "against ";

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

#if defined(CALLGRIND_DUMP_STATS_AT)
void Count(const std::string& name, const std::function<void()>& run)
{
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  run();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
}
#endif

void Read(const std::filesystem::path& file, std::map<std::string, InstructionCount>& counts)
{
  std::ifstream lines(file);
  std::string name;
  for (std::string line; std::getline(lines, line);)
  {
    if (StartsWith(line, Trigger))
    {
      name = line.substr(Trigger.size());
    }
    else if (StartsWith(line, Totals) && StartsWith(name, Ours))
    {
      counts[name.substr(Ours.size())].Ours = std::stod(line.substr(Totals.size()));
    }
    else if (StartsWith(line, Totals) && StartsWith(name, Against))
    {
      counts[name.substr(Against.size())].Against = std::stod(line.substr(Totals.size()));
    }
  }
}
} // namespace

bool CountInstructions(const std::vector<PairedBenchmark>& pairs)
{
#if defined(CALLGRIND_DUMP_STATS_AT)
  if (RUNNING_ON_VALGRIND == 0)
  {
    return false;
  }
  for (const PairedBenchmark& pair : pairs)
  {
    if (pair.IsCounted)
    {
      Count(Ours + pair.Name, pair.Run);
      Count(Against + pair.Name, pair.RunAgainst);
    }
  }
  return true;
#else
  return false;
#endif
}

std::map<std::string, InstructionCount> ReadInstructionCounts(const std::string& folder)
{
  std::map<std::string, InstructionCount> counts;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
  {
    Read(entry.path(), counts);
  }
  return counts;
}
} // namespace palpate::bench
