#pragma once

#include "PairedBenchmark.h"

#include <map>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Instructions of one run of both sides of a benchmark.
struct InstructionCount
{
  double Ours = 0.0;
  double Against = 0.0;
};

/// Runs both sides of each pair once and has callgrind write how many instructions each took, to
/// the files that it was told to write. Does nothing and returns false unless this program runs
/// under `valgrind --tool=callgrind --instr-atstart=no` and was built where valgrind's headers are:
/// a virtual machine seldom lets a program count its own.
bool CountInstructions(const std::vector<PairedBenchmark>& pairs);

/// What CountInstructions left in a folder, by the names of the benchmarks; empty if there is
/// nothing.
std::map<std::string, InstructionCount> ReadInstructionCounts(const std::string& folder);
} // namespace palpate::bench
