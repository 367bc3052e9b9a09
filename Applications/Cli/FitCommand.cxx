#include "FitCommand.h"

#include "CaseText.h"
#include "Console.h"
#include "FilterRun.h"
#include "FitFiles.h"
#include "FitJson.h"
#include "FitStructure.h"
#include "InputError.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"
#include "StageClock.h"
#include "VolumeCoverage.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>

namespace palpate::cli
{
namespace
{
constexpr int Failure = 1;

std::string Line(const FitResult& result)
{
  std::ostringstream text;
  text << CaseTitle(result.Input, result.Structure) << ": ";
  text << std::fixed << "degree " << result.Model.Degree() << ", Dice " << std::setprecision(4)
       << result.Dice << ", distance to the mask's boundary mean " << std::setprecision(3)
       << result.ModelToMask.Mean << " / 95 % " << result.ModelToMask.Percentile95 << " / max "
       << result.ModelToMask.Maximum << " mm, volume " << std::setprecision(2)
       << result.ModelMilliliters << " ml (mask " << result.MaskMilliliters << " ml), "
       << (result.StarShaped ? "star-shaped" : "not quite star-shaped") << " ("
       << result.HiddenPercent << " % hidden)\n";
  return text.str();
}

// Until its model is there, a case fails by what the structure is and what the options ask of it:
// no such component, too thin for a surface, too few samples for the degree.
void BlameInput(FitResult& result)
{
  const bool isFitReached = std::any_of(result.Seconds.begin(), result.Seconds.end(),
                                        [](const auto& stage) { return stage.first == "fit"; });
  if (result.State == FitResult::Outcome::Failed && !isFitReached)
  {
    result.State = FitResult::Outcome::BadInput;
  }
}

void RemarkOnVolume(const Volume& volume, FitResult& result)
{
  if (result.Surface == nullptr || result.Surface->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (const std::string note = CoverageNote(volume.Image, result.Surface->GetBounds());
      !note.empty())
  {
    result.Notes.push_back(note);
  }
}
} // namespace

std::string FitCommand::Examples() const
{
  return "  palpate fit mask.nii.gz --output out               every label, files and report\n"
         "  palpate fit mask.seg.nrrd --label Prostate --volume t2.nrrd --output out\n"
         "  palpate fit mask.nii.gz --degree auto --tolerance 0.3\n"
         "  palpate fit *.nii.gz --label 1 --json > results.jsonl   numbers for a script";
}

void FitCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("MASK", this->Inputs, "Segmentations: label maps, .seg.nrrd, DICOM-SEG")
      ->required();
  this->Options.DeclareLabels(app);
  this->Options.DeclareModel(app);
  this->Options.DeclareSurface(app);
  app.add_option("--volume", this->VolumePath,
                 "The image that the segmentations belong to, for the report's slices");
  this->Images.Declare(app, "--volume folder");
  app.add_option("--output", this->OutputFolder,
                 "Folder for models, surfaces and report.html (default: write nothing)")
      ->type_name("DIR");
  app.add_flag("--json", this->Json, "One JSON object a case on standard output");
}

int FitCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Settings = this->Options.Settings();
  this->Names = CaseNames(this->Inputs);
  this->Tally = {};
  this->Sentences.clear();
  this->Index = {};
  if (!this->OutputFolder.empty())
  {
    CheckOutputFolder(this->OutputFolder);
  }
  std::optional<Volume> volume;
  if (!this->VolumePath.empty())
  {
    volume = ReadVolume(this->VolumePath, this->Images.Choice());
  }
  try
  {
    for (std::size_t file = 0; file < this->Inputs.size(); ++file)
    {
      this->FitFile(file, volume ? &*volume : nullptr, console);
    }
  }
  catch (const Cancelled&)
  {
    console.EndProgress();
    console.Error("cancelled; the cases that were finished are kept");
    return Failure;
  }
  return this->Conclude(console);
}

void FitCommand::FitFile(std::size_t file, const Volume* volume, Console& console)
{
  const std::string& input = this->Inputs[file];
  std::vector<std::pair<std::string, double>> readTime;
  StageClock clock(readTime);
  Segmentation segmentation;
  try
  {
    segmentation = ReadSegmentation(input, this->Images.LeftHanded());
  }
  catch (const InputError& error)
  {
    this->RecordBadInput(input, {}, error.what(), console);
    return;
  }
  clock.EndStage("read");
  for (const std::string& note : segmentation.Notes)
  {
    console.Note(segmentation.Source.filename().string() + ": " + note);
  }
  const StructureChoice choice = ChooseStructures(segmentation, this->Options.Labels());
  for (const StructureChoice::Missing& missing : choice.Lost)
  {
    this->RecordBadInput(input, missing.Structure, missing.Message, console);
  }
  this->FitStructures(file, segmentation, choice, readTime.front().second, volume, console);
}

void FitCommand::FitStructures(std::size_t file, const Segmentation& segmentation,
                               const StructureChoice& choice, double readSeconds,
                               const Volume* volume, Console& console)
{
  const bool single = this->Inputs.size() == 1 && choice.Found.size() == 1 && choice.Lost.empty();
  const double part = 1.0 / static_cast<double>(this->Inputs.size() * choice.Found.size());
  double done = static_cast<double>(file) / static_cast<double>(this->Inputs.size());
  for (const Segment& structure : choice.Found)
  {
    FitResult result =
        this->FitCase(segmentation, structure, readSeconds, {done, done + part}, console);
    done += part;
    if (volume != nullptr)
    {
      RemarkOnVolume(*volume, result);
    }
    const std::string name = single ? std::string() : this->Names.Take(file, structure);
    const std::string folder = this->Write(result, volume, name);
    this->Record(result, folder, folder.empty() ? "" : name + "/report.html",
                 segmentation.Notes.size(), console);
  }
}

FitResult FitCommand::FitCase(const Segmentation& segmentation, const Segment& structure,
                              double readSeconds, std::pair<double, double> share,
                              Console& console) const
{
  const std::string title =
      structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
  FitResult result =
      FitStructure(segmentation, structure, this->Settings,
                   [&](double fraction, const std::string& stage)
                   {
                     console.Progress(share.first + (share.second - share.first) * fraction,
                                      title + ": " + stage);
                     return !Interruption::WasAsked();
                   });
  result.Seconds.insert(result.Seconds.begin(), {"read", readSeconds});
  BlameInput(result);
  return result;
}

std::string FitCommand::Write(FitResult& result, const Volume* volume,
                              const std::string& name) const
{
  if (this->OutputFolder.empty() || result.State == FitResult::Outcome::BadInput)
  {
    return {};
  }
  StageClock clock(result.Seconds);
  const std::filesystem::path top = this->OutputFolder;
  const std::filesystem::path folder = name.empty() ? top : top / name;
  try
  {
    WriteFitFiles(result, volume, folder, ProgramVersion());
  }
  catch (const InputError& error)
  {
    if (name.empty())
    {
      throw;
    }
    result.State = FitResult::Outcome::Failed;
    result.Message = error.what();
    return {};
  }
  clock.EndStage("write");
  return folder.string();
}

void FitCommand::RecordBadInput(const std::string& input, const Segment& structure,
                                const std::string& message, Console& console)
{
  FitResult result;
  result.Input = input;
  result.CaseName = CaseNameOf(input);
  result.Structure = structure;
  result.Settings = this->Settings;
  result.State = FitResult::Outcome::BadInput;
  result.Message = message;
  this->Record(result, {}, {}, 0, console);
}

void FitCommand::Record(FitResult& result, const std::string& folder, const std::string& report,
                        std::size_t fileNotes, Console& console)
{
  const double total =
      std::accumulate(result.Seconds.begin(), result.Seconds.end(), 0.0,
                      [](double sum, const auto& stage) { return sum + stage.second; });
  result.Seconds.emplace_back("total", total);
  this->Index.Add(result, report);
  ++this->Tally.Cases;
  if (result.State != FitResult::Outcome::Fitted)
  {
    ++(result.State == FitResult::Outcome::BadInput ? this->Tally.BadInputs : this->Tally.Failures);
    this->Sentences.push_back(CaseSentence(result.Input, result.Structure, result.Message));
  }
  console.EndProgress();
  if (this->Json)
  {
    console.Output() << FitResultJson(result, folder) << '\n' << std::flush;
  }
  else if (result.State == FitResult::Outcome::Fitted)
  {
    console.Output() << Line(result) << std::flush;
  }
  // What was said of the whole file comes first in a result's notes; it is not said again.
  for (std::size_t n = fileNotes; n < result.Notes.size(); ++n)
  {
    console.Note(CaseTitle(result.Input, result.Structure) + ": " + result.Notes[n]);
  }
}

bool FitCommand::WriteIndex(Console& console) const
{
  const std::filesystem::path folder = this->OutputFolder;
  try
  {
    RemoveEarlierFit(folder);
    this->Index.Write(folder / "report.html");
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
  for (const std::string& sentence : this->Sentences)
  {
    console.Error(sentence);
  }
  if (this->Tally.Lost() > 0 && this->Tally.Cases > 1)
  {
    console.Error(std::to_string(this->Tally.Lost()) + " of " + std::to_string(this->Tally.Cases) +
                  " cases were not fitted");
  }
  const bool hasIndex = !this->OutputFolder.empty() && this->Tally.Cases > 1 &&
                        this->Tally.BadInputs < this->Tally.Cases;
  if (hasIndex && !this->WriteIndex(console))
  {
    return Failure;
  }
  return this->Tally.ExitCode();
}
} // namespace palpate::cli
