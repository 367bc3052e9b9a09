#pragma once

#include "PairedBenchmark.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Number of instructions of each side of a benchmark: unlike times, independent of the run and of
/// other programs. Counted by Callgrind, which runs the program on a simulated processor, so
/// counting and timing are two runs.
class InstructionCounts
{
public:
  /// No counts.
  InstructionCounts() = default;
  /// Reads Callgrind's dumps from a folder, written while Count ran under it; ignores unrelated
  /// dumps.
  explicit InstructionCounts(const std::filesystem::path& folder);

  /// Instructions of one run of a side, by its name; empty if they were not counted.
  std::optional<double> Of(const std::string& name) const;

  /// Runs both sides of each pair, first uncounted, and has Callgrind dump the counts of the second
  /// run. Returns false if the program does not run under Valgrind.
  [[nodiscard]] static bool Count(const std::vector<PairedBenchmark>& pairs);

private:
  std::map<std::string, double> Counts;
};
} // namespace palpate::bench
