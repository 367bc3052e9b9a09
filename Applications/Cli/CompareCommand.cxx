#include "CompareCommand.h"

#include "CaseText.h"
#include "CommandProgress.h"
#include "ComparisonFiles.h"
#include "ComparisonJson.h"
#include "ComparisonText.h"
#include "Console.h"
#include "FileFormat.h"
#include "FileType.h"
#include "FilterRun.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "StructurePairs.h"
#include "SurfaceFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <ostream>
#include <utility>

namespace palpate::cli
{
namespace
{
bool IsFolder(const std::filesystem::path& path)
{
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

bool IsDicomSeriesChosen(const ImageOptions& images)
{
  return !images.Choice().Series.empty();
}
} // namespace

std::string CompareCommand::Examples() const
{
  return "  palpate compare reader1.nii.gz reader2.nii.gz --output compared\n"
         "  palpate compare mask.nii.gz model.json                 a mask and its model\n"
         "  palpate compare a.seg.nrrd b.seg.nrrd --label Prostate --tolerance 1,2.5\n"
         "  palpate compare scan.stl model.json --json             a surface and a model\n"
         "  palpate compare readers/1 readers/2 --output compared  files of the same names\n"
         "  palpate compare masks fitted --output compared         a folder, and what fit made of "
         "it";
}

void CompareCommand::DeclareOptions(CLI::App& app)
{
  const std::string kinds = "segmentation, surface (" +
                            ListOfEndings(SurfaceFormats().ReadEndings()) + ") or model (" +
                            ListOfEndings(ReadableModelEndings()) + "), or a folder of them";
  app.add_option("FIRST", this->First, "What is compared: " + kinds)
      ->check(FileType::Input("file"));
  app.add_option("REFERENCE", this->Reference, "What it is compared with: the same kinds")
      ->check(FileType::Input("file"));
  app.add_option("--pairs", this->List,
                 "Table of pairs instead: case,first,reference,label; paths are relative to its "
                 "folder")
      ->type_name("CSV")
      ->check(FileType::Input("file", ".csv"));
  app.add_option("--label", this->Label,
                 "Structure of a segmentation (default: all that both have, by number)")
      ->type_name("N|NAME");
  app.add_option("--reference-label", this->ReferenceLabel,
                 "Structure of REFERENCE, if it is another one")
      ->type_name("N|NAME");
  app.add_option("--tolerance", this->Tolerances, "Tolerances of the surface Dice, mm")
      ->type_name("MM")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(FiniteNumber::Between(0.0, 1000.0))
      ->capture_default_str();
  this->Images.Declare(app, "folder");
  app.add_option(
         "--output", this->OutputFolder,
         "Folder for report.html, map.png, the surfaces with their distances (.vtp), and of "
         "folders comparison.csv (default: write nothing)")
      ->type_name("DIR")
      ->check(FileType::Output("directory"));
  app.add_flag("--json", this->Json, "Print one JSON object per pair");
}

int CompareCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Results.clear();
  this->Unpaired.clear();
  std::sort(this->Tolerances.begin(), this->Tolerances.end());
  if (!this->OutputFolder.empty())
  {
    CheckOutputFolder(this->OutputFolder);
  }
  if (!this->List.empty())
  {
    if (!this->First.empty())
    {
      throw InputError("--pairs lists the files; leave out FIRST and REFERENCE");
    }
    return this->RunCases(CasePairs::OfTable(this->List), console);
  }
  if (this->First.empty() || this->Reference.empty())
  {
    throw InputError("FIRST and REFERENCE are required; see palpate compare --help");
  }
  const bool isFolder = IsFolder(this->First);
  if (isFolder != IsFolder(this->Reference))
  {
    throw InputError((isFolder ? this->First : this->Reference).string() +
                     " is a folder, and the other one is not; give two files or two folders");
  }
  return isFolder && !IsDicomSeriesChosen(this->Images)
             ? this->RunCases(CasePairs::OfFolders(this->First, this->Reference), console)
             : this->RunFiles(console);
}

int CompareCommand::RunFiles(Console& console)
{
  this->IsTable = false;
  this->CompareFiles({{}, this->First, this->Reference, {}}, {}, console);
  for (const std::string& message : this->Unpaired)
  {
    console.Note(message);
  }
  return this->Conclude(console);
}

// A cohort's models are one structure each, and their labels are numbers.
CasePairs CompareCommand::Chosen(CasePairs cases) const
{
  const auto isOther = [this](const CasePairs::Pair& pair)
  { return !this->Label.empty() && !pair.Label.empty() && pair.Label != this->Label; };
  cases.Pairs.erase(std::remove_if(cases.Pairs.begin(), cases.Pairs.end(), isOther),
                    cases.Pairs.end());
  if (cases.Pairs.empty())
  {
    throw InputError("no pair has the label " + this->Label +
                     "; give the number of one that was fitted");
  }
  return cases;
}

int CompareCommand::RunCases(const CasePairs& all, Console& console)
{
  const CasePairs cases = this->Chosen(all);
  this->IsTable = true;
  this->Unpaired = cases.Unpaired;
  const auto count = static_cast<double>(cases.Pairs.size());
  for (std::size_t i = 0; i < cases.Pairs.size(); ++i)
  {
    if (Interruption::WasAsked())
    {
      throw Cancelled();
    }
    const CasePairs::Pair& one = cases.Pairs[i];
    this->CompareCase(one,
                      {static_cast<double>(i) / count, static_cast<double>(i + 1) / count,
                       CountedCase(i + 1, cases.Pairs.size(), one.Case)},
                      console);
  }
  console.EndProgress();
  for (const std::string& message : this->Unpaired)
  {
    console.Note(message);
  }
  if (!this->OutputFolder.empty())
  {
    WriteComparisonOverview(this->Results, this->Unpaired, this->Tolerances, this->OutputFolder);
    console.Note("overview: " + (this->OutputFolder / "report.html").string());
  }
  if (!this->Json)
  {
    console.Output() << SummaryText(this->Results);
  }
  return this->Conclude(console);
}

void CompareCommand::CompareCase(const CasePairs::Pair& one, const Part& part, Console& console)
{
  PairComparison lost;
  lost.Case = one.Case;
  lost.One.File = one.One;
  lost.Other.File = one.Other;
  try
  {
    this->CompareFiles(one, part, console);
    return;
  }
  catch (const InputError& error)
  {
    lost.State = FitResult::Outcome::BadInput;
    lost.Message = error.what();
  }
  catch (const std::bad_alloc&)
  {
    lost.State = FitResult::Outcome::Failed;
    lost.Message = one.One.string() + " needs more memory than there is; crop or resample it.";
  }
  this->Take(std::move(lost), false, console);
}

void CompareCommand::CompareFiles(const CasePairs::Pair& files, const Part& part, Console& console)
{
  const ComparedFile one = ComparedFile::Read(files.One, this->Images.Choice());
  const ComparedFile other = ComparedFile::Read(files.Other, this->Images.Choice());
  for (const ComparedFile* file : {&one, &other})
  {
    for (const std::string& note : file->Notes())
    {
      console.Note(file->Path().filename().string() + ": " + note);
    }
  }
  // A cohort's models are one structure each, whatever labels are asked for.
  const bool hasLabels = one.Labels() != nullptr || other.Labels() != nullptr || !this->IsTable;
  const std::string label = !hasLabels ? "" : files.Label.empty() ? this->Label : files.Label;
  StructurePairs pairs =
      StructurePairs::Of(one, other, label, hasLabels ? this->ReferenceLabel : std::string());
  for (std::string& message : pairs.Unpaired)
  {
    this->Unpaired.push_back(std::move(message));
  }
  const bool isOnly = pairs.Pairs.size() == 1 && !this->IsTable;
  const double share = (part.To - part.From) / static_cast<double>(pairs.Pairs.size());
  double from = part.From;
  for (const StructurePairs::Pair& structures : pairs.Pairs)
  {
    const auto progress = [&](double fraction, const std::string& stage)
    {
      console.Progress(from + share * fraction,
                       part.Title + (part.Title.empty() ? "" : ": ") + stage);
      return !Interruption::WasAsked();
    };
    PairComparison pair =
        ComparePair(one, structures.One, other, structures.Other, this->Tolerances, progress);
    pair.Case = files.Case;
    from += share;
    this->Take(std::move(pair), isOnly, console);
  }
}

std::filesystem::path CompareCommand::FolderOf(const PairComparison& pair, bool isOnly) const
{
  return isOnly ? this->OutputFolder : this->OutputFolder / PairFolder(pair);
}

void CompareCommand::Take(PairComparison&& pair, bool isOnly, Console& console)
{
  std::filesystem::path folder;
  if (pair.IsCompared() && !this->OutputFolder.empty())
  {
    folder = this->FolderOf(pair, isOnly);
    WriteComparisonFiles(pair, folder);
  }
  console.EndProgress();
  if (this->Json)
  {
    console.Output() << ComparisonJson(pair, folder.string()) << '\n' << std::flush;
  }
  else if (pair.IsCompared())
  {
    console.Output() << (this->IsTable ? ComparisonLine(pair) : ComparisonText(pair)) << std::flush;
  }
  for (const std::string& note : pair.Notes)
  {
    console.Note((pair.Case.empty() ? "" : pair.Case + ": ") + note);
  }
  if (!pair.IsCompared())
  {
    console.Error(pair.Message);
  }
  pair.Forget();
  this->Results.push_back(std::move(pair));
}

int CompareCommand::Conclude(Console& console)
{
  console.EndProgress();
  CaseTally tally;
  for (const PairComparison& pair : this->Results)
  {
    tally.Add(pair.State);
  }
  return tally.Conclude(console, "were not compared");
}
} // namespace palpate::cli
