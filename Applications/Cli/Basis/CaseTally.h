#pragma once

#include "Console.h"
#include "FitResult.h"

#include <string>

namespace palpate::cli
{
/// Counts the outcomes of the cases of one run, and gives the exit code.
struct CaseTally
{
  int Cases = 0;
  int BadInputs = 0;
  int Failures = 0; ///< without the bad inputs

  void Add(FitResult::Outcome outcome)
  {
    ++this->Cases;
    this->BadInputs += outcome == FitResult::Outcome::BadInput ? 1 : 0;
    this->Failures +=
        outcome == FitResult::Outcome::Refused || outcome == FitResult::Outcome::Failed ? 1 : 0;
  }
  int Lost() const { return this->BadInputs + this->Failures; }
  /// 0 if all succeeded, 2 if every case was bad input, 1 otherwise.
  int ExitCode() const
  {
    if (this->Lost() == 0)
    {
      return 0;
    }
    return this->BadInputs == this->Cases ? 2 : 1;
  }
  /// Reports how many of several cases were lost, e.g. "were not fitted"; returns the exit code.
  int Conclude(Console& console, const std::string& lost) const
  {
    if (this->Lost() > 0 && this->Cases > 1)
    {
      console.Error(std::to_string(this->Lost()) + " of " + std::to_string(this->Cases) +
                    " cases " + lost);
    }
    return this->ExitCode();
  }
};
} // namespace palpate::cli
