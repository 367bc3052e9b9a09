#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palpate::bench
{
/// One of our functions and a named alternative for the same job, timed in the same run. A time
/// alone means nothing on another machine; the ratio does.
struct PairedBenchmark
{
  std::string Name;    ///< e.g. "sh/fit/4002x169"
  std::string Against; ///< e.g. "Eigen ColPivHouseholderQR"
  std::function<void()> Run;
  std::function<void()> RunAgainst;
  /// Empty if the results of the last two runs agree, otherwise a message that says how they
  /// differ.
  std::function<std::string()> Disagreement;
  /// Number of items per run; times are per item.
  double Items = 1.0;
  /// Whether Callgrind counts its instructions: not those of an OpenGL that compiles at run time.
  bool IsCounted = true;

  /// Name of the alternative's times and instructions.
  std::string AlternativeName() const { return this->Name + " against"; }
};

/// One line of the results. Times are real time, the shortest of many short repetitions.
struct Comparison
{
  std::string Name;
  double Nanoseconds;
  std::string Against;
  double AgainstNanoseconds;
  /// Per item; empty if they were not counted.
  std::optional<double> Instructions;
  std::optional<double> AgainstInstructions;

  double Ratio() const { return this->AgainstNanoseconds / this->Nanoseconds; }
};

/// Runs both sides of each pair once and compares their results. Returns the messages of those that
/// disagree.
std::vector<std::string> Disagreements(const std::vector<PairedBenchmark>& pairs);

class InstructionCounts;

/// Times both sides of each pair with Google Benchmark, and adds the instructions counted before.
std::vector<Comparison> Measure(const std::vector<PairedBenchmark>& pairs,
                                const InstructionCounts& counts);
} // namespace palpate::bench
