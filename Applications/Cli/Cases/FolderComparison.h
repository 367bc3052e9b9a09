#pragma once

#include "CasePairs.h"
#include "FileComparison.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::cli
{
class Console;

/// Compares the pairs of two folders, or of a list. With an output folder it keeps
/// `comparison.csv`, which is replaced whole after every case: a run that was stopped is resumed by
/// the next one, which compares only pairs that are missing or failed, and those whose files or
/// settings changed. One run at a time writes into a folder.
class FolderComparison
{
public:
  FolderComparison(CasePairs cases, const CompareSettings& settings);
  /// Cases at a time, each in a process of its own; 1: in this one.
  void SetJobs(unsigned jobs) { this->Jobs = jobs; }

  /// Returns the exit code. Throws InputError if the output cannot be written or another run writes
  /// there, and Cancelled.
  int Run(Console& console);

private:
  int RunAlone(Console& console);
  std::string KeyOf(const CasePairs::Pair& files) const;
  /// Takes the results of an earlier run, and returns the cases to compare.
  std::vector<std::size_t> KeepDone();
  bool IsDone(const std::vector<PairComparison>& results) const;
  /// Errors of a case become its result.
  std::vector<PairComparison> CompareCase(std::size_t number, Console& console) const;
  void Take(std::size_t number, std::vector<PairComparison> results);
  PairComparison LostCase(std::size_t number, FitResult::Outcome state,
                          const std::string& message) const;
  std::vector<PairComparison> AllResults() const;
  int Conclude(Console& console) const;

  CasePairs Cases;
  const CompareSettings& Settings;
  unsigned Jobs = 1;
  std::vector<std::string> Keys;
  std::vector<std::vector<PairComparison>> Results; ///< of each case
};
} // namespace palpate::cli
