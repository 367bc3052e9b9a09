#include "FitCommand.h"

#include "Console.h"
#include "FilterRun.h"
#include "FitFiles.h"
#include "FitJson.h"
#include "FitStructure.h"
#include "InputError.h"
#include "Interruption.h"
#include "ProgramVersion.h"
#include "StageClock.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>

namespace palpate::cli
{
namespace
{
constexpr int Success = 0;
constexpr int Failure = 1;
constexpr int BadInput = 2;

std::string CaseTitle(const FitResult& result)
{
  std::string title =
      result.Input.filename().string() + ", label " + std::to_string(result.Structure.Label);
  return result.Structure.Name.empty() ? title : title + " (" + result.Structure.Name + ")";
}

std::string Line(const FitResult& result)
{
  std::ostringstream text;
  text << CaseTitle(result) << ": ";
  if (result.State != FitResult::Outcome::Fitted)
  {
    text << OutcomeWord(result.State) << ": " << result.Message << '\n';
    return text.str();
  }
  text << std::fixed << "degree " << result.Model.Degree() << ", Dice " << std::setprecision(4)
       << result.Dice << ", distance to the mask's boundary mean " << std::setprecision(3)
       << result.ModelToMask.Mean << " / 95 % " << result.ModelToMask.Percentile95 << " / max "
       << result.ModelToMask.Maximum << " mm, volume " << std::setprecision(2)
       << result.ModelMilliliters << " ml (mask " << result.MaskMilliliters << " ml), "
       << (result.StarShaped ? "star-shaped" : "not quite star-shaped") << " ("
       << result.HiddenPercent << " % hidden)\n";
  return text.str();
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
  app.add_option("--series", this->Series, "DICOM series of a --volume folder: number or UID")
      ->type_name("N|UID");
  app.add_option("--output", this->OutputFolder,
                 "Folder for models, surfaces and report.html (default: write nothing)")
      ->type_name("DIR");
  app.add_flag("--json", this->Json, "One JSON object a case on standard output");
}

int FitCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Settings = this->Options.Settings();
  this->Index = {};
  std::optional<Volume> volume;
  if (!this->VolumePath.empty())
  {
    volume = ReadVolume(this->VolumePath, {this->Series});
  }
  Tally tally;
  try
  {
    for (std::size_t file = 0; file < this->Inputs.size(); ++file)
    {
      this->FitFile(file, volume ? &*volume : nullptr, console, tally);
    }
  }
  catch (const Cancelled&)
  {
    console.EndProgress();
    console.Error("cancelled; the cases that were finished are kept");
    return Failure;
  }
  return this->Conclude(tally, console);
}

std::vector<Segment> FitCommand::Choose(const Segmentation& segmentation) const
{
  if (this->Options.Labels().empty())
  {
    return segmentation.Segments;
  }
  std::vector<Segment> chosen;
  for (const std::string& word : this->Options.Labels())
  {
    chosen.push_back(segmentation.Find(word));
  }
  return chosen;
}

void FitCommand::FitFile(std::size_t file, const Volume* volume, Console& console, Tally& tally)
{
  const std::string& input = this->Inputs[file];
  std::vector<std::pair<std::string, double>> readTime;
  StageClock clock(readTime);
  Segmentation segmentation;
  std::vector<Segment> structures;
  try
  {
    segmentation = ReadSegmentation(input);
    structures = this->Choose(segmentation);
  }
  catch (const InputError& error)
  {
    FitResult result;
    result.Input = input;
    result.CaseName = CaseNameOf(input);
    result.Settings = this->Settings;
    result.State = FitResult::Outcome::BadInput;
    result.Message = error.what();
    ++tally.Cases;
    ++tally.BadInputs;
    tally.Sentences.emplace_back(error.what());
    if (this->Json)
    {
      console.Output() << FitResultJson(result, {}) << '\n';
    }
    return;
  }
  clock.EndStage("read");
  for (const std::string& note : segmentation.Notes)
  {
    console.Note(segmentation.Source.filename().string() + ": " + note);
  }
  const bool single = this->Inputs.size() == 1 && structures.size() == 1;
  for (std::size_t s = 0; s < structures.size(); ++s)
  {
    const auto share = [&](std::size_t done)
    {
      return (static_cast<double>(file) +
              static_cast<double>(done) / static_cast<double>(structures.size())) /
             static_cast<double>(this->Inputs.size());
    };
    FitResult result = this->FitCase(segmentation, structures[s], readTime.front().second, share(s),
                                     share(s + 1), console);
    this->Finish(result, volume, single, segmentation.Notes.size(), console, tally);
  }
}

FitResult FitCommand::FitCase(const Segmentation& segmentation, const Segment& structure,
                              double readSeconds, double from, double to, Console& console) const
{
  const std::string title =
      structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
  FitResult result =
      FitStructure(segmentation, structure, this->Settings,
                   [&](double fraction, const std::string& stage)
                   {
                     console.Progress(from + (to - from) * fraction, title + ": " + stage);
                     return !Interruption::WasAsked();
                   });
  result.Seconds.insert(result.Seconds.begin(), {"read", readSeconds});
  return result;
}

void FitCommand::Finish(FitResult& result, const Volume* volume, bool single, std::size_t fileNotes,
                        Console& console, Tally& tally)
{
  ++tally.Cases;
  const bool bad = result.State == FitResult::Outcome::BadInput;
  std::string folder;
  if (!this->OutputFolder.empty() && !bad)
  {
    StageClock clock(result.Seconds);
    const std::filesystem::path top = this->OutputFolder;
    const std::string name = single ? std::string() : CaseFolderName(result);
    folder = (single ? top : top / name).string();
    WriteFitFiles(result, volume, folder, ProgramVersion());
    if (!single)
    {
      this->Index.Add(result, name + "/report.html");
    }
    clock.EndStage("write");
  }
  const double total =
      std::accumulate(result.Seconds.begin(), result.Seconds.end(), 0.0,
                      [](double sum, const auto& stage) { return sum + stage.second; });
  result.Seconds.emplace_back("total", total);
  if (result.State != FitResult::Outcome::Fitted)
  {
    ++(bad ? tally.BadInputs : tally.OtherFailures);
    tally.Sentences.push_back(CaseTitle(result) + " " + result.Message);
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
    console.Note(CaseTitle(result) + ": " + result.Notes[n]);
  }
}

int FitCommand::Conclude(const Tally& tally, Console& console) const
{
  console.EndProgress();
  const int failures = tally.BadInputs + tally.OtherFailures;
  for (const std::string& sentence : tally.Sentences)
  {
    console.Error(sentence);
  }
  if (failures > 0 && tally.Cases > 1)
  {
    console.Error(std::to_string(failures) + " of " + std::to_string(tally.Cases) +
                  " cases were not fitted");
  }
  if (!this->OutputFolder.empty() && tally.Cases > 1 && tally.BadInputs < tally.Cases)
  {
    const std::filesystem::path index = std::filesystem::path(this->OutputFolder) / "report.html";
    this->Index.Write(index);
    console.Note("overview: " + index.string());
  }
  if (failures == 0)
  {
    return Success;
  }
  return tally.Cases == 1 && tally.BadInputs == 1 ? BadInput : Failure;
}
} // namespace palpate::cli
