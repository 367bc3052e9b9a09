#include "CohortFit.h"

#include "CaseFit.h"
#include "CaseNames.h"
#include "CasePattern.h"
#include "CaseProcesses.h"
#include "CaseTally.h"
#include "CaseText.h"
#include "CommandProgress.h"
#include "Console.h"
#include "EarlierFiles.h"
#include "FitJson.h"
#include "FitStructure.h"
#include "FolderLock.h"
#include "InputError.h"
#include "OutputFolder.h"
#include "OutputNames.h"
#include "ProgramVersion.h"
#include "ReportIndex.h"

#include <algorithm>
#include <set>
#include <utility>

namespace palpate::cli
{
namespace
{
// Held while the table is read, changed and written.
constexpr const char* TableLock = ".palpate-cohort.lock";
} // namespace

CohortFit::CohortFit(const FitSettings& settings, const std::vector<std::string>& labels,
                     const ImageOptions& images)
    : Settings(settings), Labels(labels), Images(images)
{
}

void CohortFit::TakeMasks(const std::vector<std::string>& inputs)
{
  if (std::any_of(inputs.begin(), inputs.end(), IsCasePattern))
  {
    this->TakePattern(inputs);
    return;
  }
  std::vector<std::string> masks;
  for (const std::string& input : inputs)
  {
    std::error_code ignored;
    if (!std::filesystem::is_directory(input, ignored))
    {
      masks.push_back(input);
      continue;
    }
    for (const std::filesystem::path& mask : FindMasks(input))
    {
      masks.push_back(mask.string());
    }
  }
  const CaseNames names(masks);
  for (std::size_t i = 0; i < masks.size(); ++i)
  {
    this->Cases.push_back({names.OfInput(i), masks[i], {}, {}});
  }
  this->ListCases();
}

void CohortFit::TakePattern(const std::vector<std::string>& inputs)
{
  if (inputs.size() > 1)
  {
    throw InputError("a pattern with {id} lists all cases; give it alone");
  }
  this->Cases = FindPatternCases(inputs.front());
  this->ListCases();
}

void CohortFit::TakeManifest(const std::string& manifest, const std::vector<std::string>& inputs)
{
  std::error_code ignored;
  if (inputs.size() > 1 ||
      (inputs.size() == 1 && !std::filesystem::is_directory(inputs.front(), ignored)))
  {
    throw InputError("--manifest lists the masks; besides it, give at most one folder, to which "
                     "its paths are relative");
  }
  this->Cases = ReadManifest(manifest, inputs.empty() ? std::string() : inputs.front());
  this->ListCases();
}

void CohortFit::ListCases()
{
  this->Listed.clear();
  for (const CohortCase& one : this->Cases)
  {
    this->Listed.push_back(one.Name);
  }
}

void CohortFit::ChooseCases(const std::vector<std::string>& names)
{
  std::vector<CohortCase> chosen;
  for (const std::string& name : names)
  {
    const auto found = std::find_if(this->Cases.begin(), this->Cases.end(),
                                    [&](const CohortCase& one) { return one.Name == name; });
    if (found == this->Cases.end())
    {
      throw InputError("--case " + name + " is not listed; give the name of a listed case");
    }
    chosen.push_back(*found);
  }
  this->IsPart = !chosen.empty();
  this->Cases = this->IsPart ? chosen : this->Cases;
}

int CohortFit::Run(const std::filesystem::path& output, Console& console)
{
  this->Output = output;
  CheckOutputFolder(output);
  RequireEarlierFiles(output, {"report.html"});
  MakeOutputFolder(output);
  FolderLock atWork(output, ".palpate-cohort-runs.lock");
  {
    FolderLock table(output, TableLock);
    table.WaitAlone();
    const bool isAlone = atWork.TryAlone();
    atWork.Share();
    this->ReadEarlierRows(isAlone);
  }
  this->RunCases(console);
  return this->Conclude(console);
}

void CohortFit::TakeRowsOfOthers()
{
  const CohortTable table = CohortTable::Read(this->Output / "cohort.csv");
  std::map<std::string, std::vector<CohortRow>> rows;
  for (const std::string& name : this->Mine)
  {
    rows[name] = this->Rows[name];
  }
  this->Order = this->Listed;
  std::set<std::string> known(this->Order.begin(), this->Order.end());
  for (const CohortRow& row : table.Rows())
  {
    if (this->Mine.count(row.Case) == 0)
    {
      rows[row.Case].push_back(row);
    }
    if (known.insert(row.Case).second)
    {
      this->Order.push_back(row.Case);
    }
  }
  this->Rows = std::move(rows);
}

// Cases that are no longer listed leave the table, unless only a part was asked for, or a
// concurrent run may list them.
void CohortFit::ReadEarlierRows(bool isAlone)
{
  this->TakeRowsOfOthers();
  if (this->IsPart || !isAlone || this->Order.size() == this->Listed.size())
  {
    return;
  }
  this->Order = this->Listed;
  this->Table().Write(this->Output / "cohort.csv");
  this->TakeRowsOfOthers();
}

void CohortFit::WriteTable()
{
  FolderLock lock(this->Output, TableLock);
  lock.WaitAlone();
  this->TakeRowsOfOthers();
  this->Table().Write(this->Output / "cohort.csv");
}

std::vector<std::string> CohortFit::LabelsOf(const CohortCase& one) const
{
  return one.Label.empty() ? this->Labels : std::vector<std::string>{one.Label};
}

std::string CohortFit::KeyOf(const CohortCase& one) const
{
  std::vector<std::string> labels = this->LabelsOf(one);
  if (const std::string values = this->Images.ValueText(); !values.empty())
  {
    labels.push_back(values); // other voxels are other structures
  }
  return CohortKey(one.Mask, one.Volume, labels, this->Settings, ProgramVersion());
}

bool CohortFit::IsDone(const CohortCase& one) const
{
  const auto found = this->Rows.find(one.Name);
  const std::string key = this->KeyOf(one);
  return found != this->Rows.end() &&
         std::all_of(found->second.begin(), found->second.end(),
                     [&](const CohortRow& row)
                     {
                       std::error_code ignored;
                       return row.Key == key && row.Result.State != FitResult::Outcome::Failed &&
                              (row.Model.empty() ||
                               std::filesystem::exists(this->Output / row.Model, ignored));
                     });
}

void CohortFit::RunCases(Console& console)
{
  std::vector<std::size_t> pending;
  for (std::size_t i = 0; i < this->Cases.size(); ++i)
  {
    if (this->IsDone(this->Cases[i]))
    {
      this->Mine.insert(this->Cases[i].Name);
      continue;
    }
    pending.push_back(i);
  }
  const std::size_t kept = this->Cases.size() - pending.size();
  palpate::cli::RunCases(
      pending.size(), this->Jobs, console,
      [&](std::size_t number, Console& own)
      {
        this->RunCase(pending[number], own);
        return std::string();
      },
      [&](std::size_t number, const std::string&, const std::string& reason)
      {
        if (!reason.empty())
        {
          this->RecordLost(this->Cases[pending[number]], reason, console);
        }
      });
  this->TakeRowsOfOthers(); // those of other processes
  if (kept > 0)
  {
    console.Note(std::to_string(kept) + " of " + std::to_string(this->Cases.size()) +
                 " cases were done before and are kept");
  }
}

void CohortFit::RunCase(std::size_t number, Console& console)
{
  // Before the mask is read: a mask that changes meanwhile is fitted again.
  const std::string key = this->KeyOf(this->Cases[number]);
  std::vector<CohortRow> rows = this->FitOne(number, console);
  std::for_each(rows.begin(), rows.end(), [&](CohortRow& row) { row.Key = key; });
  this->Rows[this->Cases[number].Name] = std::move(rows);
  this->Mine.insert(this->Cases[number].Name);
  this->WriteTable();
}

void CohortFit::RecordLost(const CohortCase& one, const std::string& reason, Console& console)
{
  FitResult result;
  result.Input = one.Mask;
  result.CaseName = CaseNameOf(one.Mask);
  result.Settings = this->Settings;
  result.State = FitResult::Outcome::Failed;
  result.Message = one.Mask.string() + ": " + reason;
  if (this->Json)
  {
    console.Relay(FitResultJson(result, {}) + '\n', {});
  }
  this->Rows[one.Name] = {RowOf(one.Name, std::move(result))};
  this->Mine.insert(one.Name);
  this->WriteTable();
}

std::vector<CohortRow> CohortFit::FitOne(std::size_t number, Console& console) const
{
  const CohortCase& one = this->Cases[number];
  const auto count = static_cast<double>(this->Cases.size());
  MaskToFit mask;
  mask.Mask = one.Mask;
  mask.Name = one.Name;
  mask.Labels = this->LabelsOf(one);
  mask.Settings = this->Settings;
  mask.SlicesFile = one.Volume;
  mask.Output = this->Output;
  mask.PlaceOf = [&](const Segment& structure)
  { return std::filesystem::path(PlainName(one.Name)) / StructureFolderName(structure); };
  mask.Json = this->Json;
  mask.From = static_cast<double>(number) / count;
  mask.To = static_cast<double>(number + 1) / count;
  mask.TitleOf = [&](std::size_t, std::size_t all, const Segment& structure)
  {
    return CountedCase(number + 1, this->Cases.size(), one.Name) +
           (all > 1 ? ", " + ShortTitle(structure) : "");
  };
  std::vector<CohortRow> rows;
  FitMask(mask, this->Images, console,
          [&](FitResult&& result, const std::filesystem::path& place, bool)
          {
            const bool isFitted = result.State == FitResult::Outcome::Fitted;
            rows.push_back(RowOf(one.Name, std::move(result)));
            rows.back().Model = isFitted ? place / "model.json" : "";
          });
  return rows;
}

CohortTable CohortFit::Table() const
{
  CohortTable table;
  for (const std::string& name : this->Order)
  {
    if (const auto found = this->Rows.find(name); found != this->Rows.end())
    {
      table.Add(found->second);
    }
  }
  return table;
}

void CohortFit::WriteOverview(const CohortTable& table, Console& console) const
{
  ReportIndex index;
  for (const CohortRow& row : table.Rows())
  {
    index.Add(row.Result, row.Degree,
              row.Model.empty() ? "" : row.Model.parent_path() / "report.html");
  }
  index.Write(this->Output / "report.html");
  console.Note("overview: " + (this->Output / "report.html").string());
}

int CohortFit::Conclude(Console& console)
{
  {
    FolderLock lock(this->Output, TableLock);
    lock.WaitAlone();
    this->TakeRowsOfOthers();
    const CohortTable table = this->Table();
    table.Write(this->Output / "cohort.csv");
    this->WriteOverview(table, console);
  }
  CaseTally tally;
  for (const CohortCase& one : this->Cases)
  {
    for (const CohortRow& row : this->Rows.at(one.Name))
    {
      tally.Add(row.Result.State);
      if (row.Result.State != FitResult::Outcome::Fitted)
      {
        console.Error(CaseMessage(row.Result.Input, row.Result.Structure, row.Result.Message));
      }
    }
  }
  return tally.Conclude(console, "were not fitted");
}
} // namespace palpate::cli
