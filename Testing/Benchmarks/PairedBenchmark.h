#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Something of ours and a named alternative that does the same job, timed in the same run. A time
/// alone says nothing on another machine; the ratio does.
struct PairedBenchmark
{
  std::string Name;    ///< e.g. "sh/fit/4002x169"
  std::string Against; ///< e.g. "Eigen ColPivHouseholderQR"
  std::function<void()> Run;
  std::function<void()> RunAgainst;
  /// Empty if the results of the last two runs agree, else a sentence that says how they do not.
  std::function<std::string()> Disagreement;
  /// How many items a run handles; times are given for one item.
  double Items = 1.0;
  /// Whether Callgrind counts its instructions: not those of an OpenGL that compiles as it goes.
  bool IsCounted = true;

  /// Under which the alternative's times and instructions are kept.
  std::string AlternativeName() const { return this->Name + " against"; }
};

/// One line of the outcome. Times are real time, the shortest of many short repetitions.
struct Comparison
{
  std::string Name;
  double Nanoseconds;
  std::string Against;
  double AgainstNanoseconds;
  /// For one item; empty where they were not counted.
  std::optional<double> Instructions;
  std::optional<double> AgainstInstructions;

  double Ratio() const { return this->AgainstNanoseconds / this->Nanoseconds; }
};

/// Runs both sides of each pair once and asks whether they agree. Returns the sentences of those
/// that do not.
std::vector<std::string> Disagreements(const std::vector<PairedBenchmark>& pairs);

class InstructionCounts;

/// Times both sides of each pair with Google Benchmark, and adds the instructions that were counted
/// before.
std::vector<Comparison> Measure(const std::vector<PairedBenchmark>& pairs,
                                const InstructionCounts& counts);
} // namespace palpate::bench
