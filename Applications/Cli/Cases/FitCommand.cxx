#include "FitCommand.h"

#include "CaseFit.h"
#include "CasePattern.h"
#include "CaseProcesses.h"
#include "CaseText.h"
#include "CohortFit.h"
#include "CommandProgress.h"
#include "Console.h"
#include "FileType.h"
#include "FitFiles.h"
#include "InputError.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "ProcessorCount.h"
#include "Progress.h"
#include "SurfaceFile.h"
#include "VolumeFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>

namespace palpate::cli
{
std::string FitCommand::Examples() const
{
  return "  palpate fit mask.nii.gz --output out               every label, with files and report\n"
         "  palpate fit mask.seg.nrrd --label Prostate --volume t2.nrrd --output out\n"
         "  palpate fit mask.nii.gz --degree auto --tolerance 0.3\n"
         "  palpate fit kidney.stl --model surface --output out    a closed surface, no mask\n"
         "  palpate fit *.nii.gz --label 1 --json > results.jsonl   numbers for a script\n"
         "  palpate fit masks --label 1 --output out       every mask of a folder; resumes after "
         "a\n"
         "                                                 stop; then: palpate cohort out";
}

void FitCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("MASK", this->Inputs,
                 "Segmentations: label maps, .seg.nrrd, DICOM-SEG; or closed surfaces (" +
                     ListOfEndings(SurfaceFormats().ReadEndings()) +
                     "); or folders of either; or a pattern with {id} and *")
      ->check(FileType::Input("label"));
  app.add_option("--manifest", this->Manifest,
                 "Table of cases: case,mask,label,volume; paths are relative to its folder, or to "
                 "MASK if that is a folder")
      ->type_name("CSV")
      ->check(FileType::Input("file", ".csv"));
  app.add_option("--case", this->Cases, "Fit only these cases of a folder or manifest")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--as", this->As,
                 "What a folder of masks holds: structures of one patient, or cases of one "
                 "structure (default: structures if they lie on one grid and hardly overlap)")
      ->check(CLI::IsMember({"structures", "cases"}));
  this->Options.DeclareLabels(app);
  this->Options.DeclareModel(app);
  this->Options.DeclareSurface(app);
  app.add_option("--volume", this->VolumePath,
                 "Image of the segmentations, for the slices of the report")
      ->check(FileType::Input("image"));
  this->Images.Declare(app, "--volume folder, or of the mask where there is no --volume");
  this->Images.DeclareValues(app);
  app.add_option("--output", this->OutputFolder,
                 "Folder for models, surfaces and report.html (default: write nothing)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder(
          {"report.html", "model.json", "model.csv", "model.vtp", "surface.vtp"}));
  app.add_option("--jobs", this->Jobs,
                 "Cases of a folder or manifest, or structures of a mask, fitted at a time "
                 "(default: one per processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--json", this->Json, "Print one JSON object per case");
}

bool FitCommand::IsCohort() const
{
  std::error_code ignored;
  return !this->Manifest.empty() ||
         std::any_of(this->Inputs.begin(), this->Inputs.end(),
                     [&](const std::string& input) {
                       return IsCasePattern(input) || std::filesystem::is_directory(input, ignored);
                     });
}

void FitCommand::TellTaken(Console& console) const
{
  if (!this->Taken.empty())
  {
    console.Note(this->Taken);
  }
}

int FitCommand::RunCohort(Console& console) const
{
  if (this->OutputFolder.empty())
  {
    throw InputError(
        "--output is required for a folder or a --manifest: it holds the table of cases");
  }
  if (!this->VolumePath.empty())
  {
    throw InputError("--volume applies to one mask; name each case's volume in the --manifest");
  }
  CohortFit fit(this->Settings, this->Options.Labels(), this->Images);
  fit.SetJson(this->Json);
  fit.SetJobs(this->Jobs > 0 ? this->Jobs : ProcessorCount());
  if (this->Manifest.empty())
  {
    fit.TakeMasks(this->Inputs);
  }
  else
  {
    fit.TakeManifest(this->Manifest, this->Inputs);
  }
  fit.ChooseCases(this->Cases);
  this->TellTaken(console);
  return fit.Run(this->OutputFolder, console);
}

// A table that is there is continued as it was begun.
bool FitCommand::MayBeStructures() const
{
  std::error_code ignored;
  return this->As != "cases" && this->Manifest.empty() && this->Cases.empty() &&
         this->Inputs.size() == 1 && IsMaskFolder(this->Inputs.front()) &&
         (this->OutputFolder.empty() ||
          !std::filesystem::exists(std::filesystem::path(this->OutputFolder) / "cohort.csv",
                                   ignored));
}

// Masks of a folder as one segmentation, if they are structures of one patient. If none can be
// read, each is a case with its message.
void FitCommand::ReadFolder(Console& console)
{
  const std::string& input = this->Inputs.front();
  const bool judges = this->As.empty();
  const auto tell = [&](std::size_t done, std::size_t count)
  {
    if (Interruption::WasAsked())
    {
      throw Cancelled();
    }
    console.Progress(0.0, "reading " + CountedCase(done + 1, count, input));
  };
  std::optional<MaskFolder> folder;
  try
  {
    folder.emplace(input, this->Images.Choice(), judges, tell);
  }
  catch (const InputError&)
  {
    if (!judges)
    {
      throw;
    }
    return;
  }
  console.EndProgress();
  if (judges)
  {
    folder->RequireClear();
    this->Taken = folder->TakenText();
  }
  if (!judges || folder->IsOneSegmentation())
  {
    this->Folder = std::move(folder);
  }
}

int FitCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Settings = this->Options.Settings();
  this->Folder.reset();
  this->Taken.clear();
  if (this->MayBeStructures())
  {
    this->ReadFolder(console);
  }
  if (!this->Folder && this->IsCohort())
  {
    return this->RunCohort(console);
  }
  if (this->Inputs.empty() || !this->Cases.empty())
  {
    throw InputError(this->Inputs.empty() ? "MASK is required; see palpate fit --help"
                                          : "--case chooses from a folder or a --manifest");
  }
  this->Names = CaseNames(this->Inputs);
  this->Tally = {};
  this->Messages.clear();
  this->Index = {};
  if (!this->OutputFolder.empty())
  {
    CheckOutputFolder(this->OutputFolder);
  }
  std::optional<Volume> volume;
  if (!this->VolumePath.empty())
  {
    volume = ReadVolume(this->VolumePath, this->Images.ChoiceOfVolume());
  }
  this->TellTaken(console);
  if (this->Folder)
  {
    for (const RefusedMask& mask : this->Folder->LeftOut())
    {
      this->Tally.Add(FitResult::Outcome::BadInput);
      this->Messages.push_back(mask.Message);
    }
  }
  for (std::size_t file = 0; file < this->Inputs.size(); ++file)
  {
    this->FitFile(file, volume ? &*volume : nullptr, console);
  }
  return this->Conclude(console);
}

void FitCommand::FitFile(std::size_t file, const Volume* volume, Console& console)
{
  const std::size_t count = this->Inputs.size();
  MaskToFit mask;
  mask.Mask = this->Inputs[file];
  mask.Name = mask.Mask.filename().string();
  mask.Read = this->Folder ? &this->Folder->Structures() : nullptr;
  mask.Labels = this->Options.Labels();
  mask.Settings = this->Settings;
  mask.KeepsLargestPart = this->Options.NamesLargest();
  mask.Slices = volume;
  mask.Output = this->OutputFolder;
  mask.PlaceOf = [&](const Segment& structure) { return this->Names.Take(file, structure); };
  mask.IsAlone = count == 1;
  mask.Json = this->Json;
  mask.AtATime = this->Jobs > 0 ? this->Jobs : ProcessorCount();
  mask.From = static_cast<double>(file) / static_cast<double>(count);
  mask.To = static_cast<double>(file + 1) / static_cast<double>(count);
  mask.TitleOf = [&](std::size_t number, std::size_t all, const Segment& structure)
  { return OfFile(file + 1, this->Inputs, CountedCase(number, all, ShortTitle(structure))); };
  FitMask(mask, this->Images, console,
          [&](const FitResult& result, const std::filesystem::path& place, bool isWritten)
          {
            this->Index.Add(result, DegreeOf(result.Model),
                            isWritten ? place / "report.html" : std::filesystem::path());
            this->Tally.Add(result.State);
            if (result.State != FitResult::Outcome::Fitted)
            {
              this->Messages.push_back(CaseMessage(result.Input, result.Structure, result.Message));
            }
          });
}

bool FitCommand::WriteIndex(Console& console) const
{
  const std::filesystem::path folder = this->OutputFolder;
  try
  {
    WriteFitOverview(this->Index, folder);
  }
  catch (const InputError& error)
  {
    console.Error(error.what());
    return false;
  }
  console.Note("overview: " + (folder / "report.html").string());
  return true;
}

int FitCommand::Conclude(Console& console) const
{
  console.EndProgress();
  for (const std::string& message : this->Messages)
  {
    console.Error(message);
  }
  const int code = this->Tally.Conclude(console, "were not fitted");
  const bool hasIndex = !this->OutputFolder.empty() && this->Tally.Cases > 1 &&
                        this->Tally.BadInputs < this->Tally.Cases;
  if (hasIndex && !this->WriteIndex(console))
  {
    return EXIT_FAILURE;
  }
  return code;
}
} // namespace palpate::cli
