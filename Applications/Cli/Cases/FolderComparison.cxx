#include "FolderComparison.h"

#include "CaseProcesses.h"
#include "CaseTally.h"
#include "CommandProgress.h"
#include "ComparisonFiles.h"
#include "ComparisonTable.h"
#include "ComparisonText.h"
#include "Console.h"
#include "DecimalText.h"
#include "FolderLock.h"
#include "InputError.h"
#include "InputKey.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"

#include <algorithm>
#include <map>
#include <new>
#include <ostream>
#include <system_error>
#include <utility>

namespace palpate::cli
{
FolderComparison::FolderComparison(CasePairs cases, const CompareSettings& settings)
    : Cases(std::move(cases)), Settings(settings), Results(Cases.Pairs.size())
{
}

std::string FolderComparison::KeyOf(const CasePairs::Pair& files) const
{
  const VolumeChoice choice = this->Settings.Images.Choice();
  std::vector<std::string> words{
      files.Case,           files.Label,
      this->Settings.Label, this->Settings.ReferenceLabel,
      choice.Series,        std::to_string(static_cast<int>(choice.LeftHanded)),
      ProgramVersion()};
  for (const double tolerance : this->Settings.Pair.Tolerances)
  {
    words.push_back(ExactText(tolerance));
  }
  words.push_back(files.Series + (this->Settings.Pair.FindsMotion ? " moved" : ""));
  for (const Vector3& landmark : this->Settings.Pair.Landmarks)
  {
    for (const double coordinate : landmark)
    {
      words.push_back(ExactText(coordinate));
    }
  }
  return KeyOfInputs({files.One, files.Other}, words);
}

bool FolderComparison::IsDone(const std::vector<PairComparison>& results) const
{
  return std::all_of(
      results.begin(), results.end(),
      [&](const PairComparison& pair)
      {
        std::error_code ignored;
        return pair.State == FitResult::Outcome::BadInput ||
               (pair.IsCompared() &&
                std::filesystem::exists(this->Settings.Output / PairFolder(pair) / "report.html",
                                        ignored));
      });
}

std::vector<std::size_t> FolderComparison::KeepDone()
{
  std::map<std::string, std::vector<PairComparison>> earlier;
  if (!this->Settings.Output.empty())
  {
    for (PairComparison& pair : ReadComparisonTable(this->Settings.Output / "comparison.csv",
                                                    this->Settings.Pair.Tolerances))
    {
      earlier[pair.Key].push_back(std::move(pair));
    }
  }
  std::vector<std::size_t> pending;
  for (std::size_t i = 0; i < this->Cases.Pairs.size(); ++i)
  {
    // Before the files are read: those that change meanwhile are compared again.
    this->Keys.push_back(this->KeyOf(this->Cases.Pairs[i]));
    const auto found = earlier.find(this->Keys.back());
    if (found == earlier.end() || !this->IsDone(found->second))
    {
      pending.push_back(i);
      continue;
    }
    this->Results[i] = std::move(found->second);
    for (PairComparison& pair : this->Results[i])
    {
      pair.One.File = this->Cases.Pairs[i].One;
      pair.Other.File = this->Cases.Pairs[i].Other;
    }
  }
  return pending;
}

PairComparison FolderComparison::LostCase(std::size_t number, FitResult::Outcome state,
                                          const std::string& message) const
{
  const CasePairs::Pair& files = this->Cases.Pairs[number];
  PairComparison lost;
  lost.Case = files.Case;
  lost.One.File = files.One;
  lost.Other.File = files.Other;
  lost.State = state;
  lost.Message = message;
  return lost;
}

std::vector<PairComparison> FolderComparison::CompareCase(std::size_t number,
                                                          Console& console) const
{
  const CasePairs::Pair& files = this->Cases.Pairs[number];
  const auto count = static_cast<double>(this->Cases.Pairs.size());
  const ComparisonPart part{static_cast<double>(number) / count,
                            static_cast<double>(number + 1) / count,
                            CountedCase(number + 1, this->Cases.Pairs.size(), files.Case)};
  PairComparison lost;
  try
  {
    return CompareFiles(files, this->Settings, true, part, console);
  }
  catch (const InputError& error)
  {
    lost = this->LostCase(number, FitResult::Outcome::BadInput, error.what());
  }
  catch (const std::bad_alloc&)
  {
    lost = this->LostCase(number, FitResult::Outcome::Failed,
                          files.One.string() +
                              " needs more memory than there is; crop or resample it.");
  }
  PrintPair(lost, this->Settings, true, {}, console);
  return {lost};
}

void FolderComparison::Take(std::size_t number, std::vector<PairComparison> results)
{
  for (PairComparison& pair : results)
  {
    pair.Key = this->Keys[number];
    pair.One.File = this->Cases.Pairs[number].One;
    pair.Other.File = this->Cases.Pairs[number].Other;
  }
  this->Results[number] = std::move(results);
  if (!this->Settings.Output.empty())
  {
    WriteComparisonTable(this->AllResults(), this->Settings.Pair.Tolerances,
                         this->Settings.Output / "comparison.csv");
  }
}

std::vector<PairComparison> FolderComparison::AllResults() const
{
  std::vector<PairComparison> all;
  for (const std::vector<PairComparison>& results : this->Results)
  {
    all.insert(all.end(), results.begin(), results.end());
  }
  return all;
}

int FolderComparison::Run(Console& console)
{
  if (this->Settings.Output.empty())
  {
    return this->RunAlone(console);
  }
  MakeOutputFolder(this->Settings.Output);
  FolderLock lock(this->Settings.Output, ".palpate-comparison.lock");
  if (!lock.TryAlone())
  {
    throw InputError("another run of palpate compare writes into " +
                     this->Settings.Output.string() + "; wait for it or give another --output");
  }
  return this->RunAlone(console);
}

int FolderComparison::RunAlone(Console& console)
{
  const std::vector<std::size_t> pending = this->KeepDone();
  RunCases(
      pending.size(), this->Jobs, console,
      [&](std::size_t number, Console& own)
      {
        return ComparisonTable(this->CompareCase(pending[number], own),
                               this->Settings.Pair.Tolerances);
      },
      [&](std::size_t number, const std::string& record, const std::string& reason)
      {
        std::vector<PairComparison> results = PairsInTable(record, this->Settings.Pair.Tolerances);
        if (!reason.empty())
        {
          results = {
              this->LostCase(pending[number], FitResult::Outcome::Failed,
                             this->Cases.Pairs[pending[number]].One.string() + ": " + reason)};
          PrintPair(results.front(), this->Settings, true, {}, console);
        }
        this->Take(pending[number], std::move(results));
      });
  const std::size_t kept = this->Cases.Pairs.size() - pending.size();
  if (kept > 0)
  {
    console.Note(std::to_string(kept) + " of " + std::to_string(this->Cases.Pairs.size()) +
                 " cases were done before and are kept");
  }
  return this->Conclude(console);
}

int FolderComparison::Conclude(Console& console) const
{
  const std::vector<PairComparison> all = this->AllResults();
  std::vector<std::string> unpaired = this->Cases.Unpaired;
  CaseTally tally;
  for (const PairComparison& pair : all)
  {
    unpaired.insert(unpaired.end(), pair.Unpaired.begin(), pair.Unpaired.end());
    tally.Add(pair.State);
  }
  for (const std::string& message : unpaired)
  {
    console.Note(message);
  }
  if (!this->Settings.Output.empty())
  {
    WriteComparisonOverview(all, unpaired, this->Settings.Pair.Tolerances, this->Settings.Output);
    console.Note("overview: " + (this->Settings.Output / "report.html").string());
  }
  if (!this->Settings.Json)
  {
    console.Output() << SummaryText(all);
  }
  return tally.Conclude(console, "were not compared");
}
} // namespace palpate::cli
