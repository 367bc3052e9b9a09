#include "CompareCommand.h"

#include "CaseProcesses.h"
#include "CaseTally.h"
#include "FileFormat.h"
#include "FileKind.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "FolderComparison.h"
#include "InputError.h"
#include "Interruption.h"
#include "MaskFolder.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "ProcessorCount.h"
#include "SurfaceFile.h"
#include "VectorText.h"

#include <CLI/CLI.hpp>
#include <algorithm>
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
         "it\n"
         "  palpate compare masks labels.seg.nrrd                  a folder of structures, by "
         "name\n"
         "  palpate compare left.json right.json --mirror          left against right\n"
         "  palpate compare heart4d.nii.gz --time 40 --output beat    phases 40 ms apart";
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
  app.add_option("--label", this->Settings.Label,
                 "Structure of a segmentation (default: all that both have, by number)")
      ->type_name("N|NAME");
  app.add_option("--reference-label", this->Settings.ReferenceLabel,
                 "Structure of REFERENCE, if it is another one")
      ->type_name("N|NAME");
  app.add_option("--tolerance", this->Settings.Pair.Tolerances,
                 "Tolerances of the surface Dice, mm")
      ->type_name("MM")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(FiniteNumber::Between(0.0, 1000.0))
      ->capture_default_str();
  app.add_flag("--mirror", this->Settings.Pair.IsMirrored,
               "Compare with the mirror image of REFERENCE at the sagittal plane, brought onto "
               "FIRST: left against right, or an organ of the midline with itself");
  app.add_option("--time", this->Times,
                 "FIRST is an image over time: compare each of its volumes with its first one; the "
                 "time of each, or the step from one to the next, in any unit")
      ->type_name("T,…")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(FiniteNumber::Any());
  app.add_flag("--motion", this->Settings.Pair.FindsMotion,
               "How REFERENCE moves to FIRST: turn, shift, and what is left (always with --time)");
  app.add_option(
         "--landmark", this->LandmarkWords,
         "A point (mm, LPS) of REFERENCE that moves with its surface; implies --motion; may "
         "be repeated")
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
  this->Settings.Images.Declare(app, "folder");
  this->Settings.Images.DeclareValues(app);
  app.add_option(
         "--output", this->Settings.Output,
         "Folder for report.html, map.png, the surfaces with their distances (.vtp), and of "
         "folders comparison.csv (default: write nothing)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({"report.html", "map.png", "first.vtp", "reference.vtp"}));
  app.add_option("--jobs", this->Jobs,
                 "Cases of folders or a list compared at a time (default: one per processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--json", this->Settings.Json, "Print one JSON object per pair");
}

int CompareCommand::Run(Console& console)
{
  const Interruption interruption;
  PairSettings& pair = this->Settings.Pair;
  for (const std::string& word : this->LandmarkWords)
  {
    pair.Landmarks.push_back(ParseVector("--landmark", word));
  }
  pair.FindsMotion = pair.FindsMotion || !pair.Landmarks.empty() || !this->Times.empty();
  std::vector<double>& tolerances = pair.Tolerances;
  std::sort(tolerances.begin(), tolerances.end());
  if (!this->Settings.Output.empty())
  {
    CheckOutputFolder(this->Settings.Output);
  }
  if (!this->List.empty())
  {
    if (!this->First.empty())
    {
      throw InputError("--pairs lists the files; leave out FIRST and REFERENCE");
    }
    return this->RunCases(CasePairs::OfTable(this->List), console);
  }
  if (!this->Times.empty())
  {
    return this->RunTimes(console);
  }
  if (this->First.empty() || this->Reference.empty())
  {
    throw InputError("FIRST and REFERENCE are required; see palpate compare --help");
  }
  const bool isFolder = IsFolder(this->First);
  if (isFolder != IsFolder(this->Reference))
  {
    // A folder may be one segmentation.
    const std::filesystem::path& folder = isFolder ? this->First : this->Reference;
    if (IsMaskFolder(folder) || !DicomFilesIn(folder).empty())
    {
      return this->RunFiles(console);
    }
    throw InputError(folder.string() +
                     " is a folder, and the other one is not; give two files or two folders");
  }
  return isFolder && !IsDicomSeriesChosen(this->Settings.Images)
             ? this->RunCases(CasePairs::OfFolders(this->First, this->Reference), console)
             : this->RunFiles(console);
}

int CompareCommand::RunTimes(Console& console) const
{
  if (this->First.empty() || !this->Reference.empty() || IsDicomSeriesChosen(this->Settings.Images))
  {
    throw InputError("--time takes FIRST alone, without REFERENCE and --series");
  }
  return this->RunCases(CasePairs::OfTimes(this->First, this->Times), console);
}

int CompareCommand::RunFiles(Console& console) const
{
  const std::vector<PairComparison> pairs =
      CompareFiles({{}, this->First, this->Reference, {}}, this->Settings, false, {}, console);
  CaseTally tally;
  for (const PairComparison& pair : pairs)
  {
    for (const std::string& message : pair.Unpaired)
    {
      console.Note(message);
    }
    tally.Add(pair.State);
  }
  return tally.Conclude(console, "were not compared");
}

// A cohort's models are one structure each, and their labels are numbers.
CasePairs CompareCommand::Chosen(CasePairs cases) const
{
  const std::string& label = this->Settings.Label;
  const auto isOther = [&label](const CasePairs::Pair& pair)
  { return !label.empty() && !pair.Label.empty() && pair.Label != label; };
  cases.Pairs.erase(std::remove_if(cases.Pairs.begin(), cases.Pairs.end(), isOther),
                    cases.Pairs.end());
  if (cases.Pairs.empty())
  {
    throw InputError("no pair has the label " + label + "; give the number of one that was fitted");
  }
  return cases;
}

int CompareCommand::RunCases(const CasePairs& all, Console& console) const
{
  if (this->Settings.Pair.IsMirrored)
  {
    throw InputError("--mirror is for two files; palpate cohort --asymmetry is for groups");
  }
  FolderComparison comparison(this->Chosen(all), this->Settings);
  comparison.SetJobs(this->Jobs > 0 ? this->Jobs : ProcessorCount());
  return comparison.Run(console);
}
} // namespace palpate::cli
