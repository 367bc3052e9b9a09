#pragma once

#include "PairedBenchmark.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate::bench
{
/// How many instructions each side of a benchmark executes: unlike times, these are the same in
/// every run and whatever else a machine does. They are counted by Callgrind, which runs the
/// program on a simulated processor, so counting and timing are two runs.
class InstructionCounts
{
public:
  /// No counts.
  InstructionCounts() = default;
  /// Reads what Callgrind dumped into a folder while Count ran under it; what is there for other
  /// reasons is passed over.
  explicit InstructionCounts(const std::filesystem::path& folder);

  /// Instructions of one run of a side, by its name; empty where they were not counted.
  std::optional<double> Of(const std::string& name) const;

  /// Runs both sides of each pair, a first time uncounted, and has Callgrind dump what the second
  /// took. False where the program does not run under Valgrind.
  [[nodiscard]] static bool Count(const std::vector<PairedBenchmark>& pairs);

private:
  std::map<std::string, double> Counts;
};
} // namespace palpate::bench
