#pragma once

#include "FuzzTarget.h"

#include <chrono>
#include <sys/types.h>

namespace palpate::test
{
/// An input that was neither read nor refused within InputLimits.
struct FuzzFailure
{
  std::uint64_t Number = 0;
  std::string What;
  std::string Bytes;
  pid_t Process = 0; ///< of the child that failed; part of the name of a sanitizer's report
};

/// Results of a run.
struct FuzzAccount
{
  std::uint64_t Read = 0;
  std::uint64_t Refused = 0;
  double LongestSeconds = 0.0;    ///< processor time of the slowest input
  std::uint64_t LargestBytes = 0; ///< memory of the largest input
  std::vector<FuzzFailure> Failures;

  std::uint64_t Inputs() const { return this->Read + this->Refused + this->Failures.size(); }
};

/// Reads inputs of one target in child processes, so that a crash, a library's assertion, a stack
/// overflow or a sanitizer's report is one failing input.
class FuzzRun
{
public:
  /// A run stops after this many failures.
  static constexpr std::size_t MostFailures = 20;

  FuzzRun(const FuzzTarget& target, std::uint64_t seed);

  /// The first inputs are the target's unchanged seeds, which must be read. Every other is a
  /// mutated seed that depends only on the target's name, `seed` and `number`.
  std::string Input(std::uint64_t number) const;

  /// Reads `inputs` inputs, or as many as `time` allows.
  FuzzAccount Run(std::uint64_t inputs, std::chrono::duration<double> time);

private:
  struct Progress;
  using Clock = std::chrono::steady_clock;

  [[noreturn]] void ReadInChild(Progress& progress, std::uint64_t end, Clock::time_point until);
  void ReadOne(const InputReader& read, Progress& progress) const;

  const FuzzTarget& Target;
  std::uint64_t Seed;
  std::vector<std::string> Seeds;
};
} // namespace palpate::test
