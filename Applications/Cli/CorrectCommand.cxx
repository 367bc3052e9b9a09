#include "CorrectCommand.h"

#include "Console.h"
#include "CorrectionFile.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "FileType.h"
#include "InputError.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"
#include "SegmentationFile.h"
#include "TextTable.h"
#include "VectorText.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <utility>

namespace palpate::cli
{
namespace
{
constexpr const char* PullForm =
    "PLACE:MM[:WIDTH] or PLACE:TARGET[:WIDTH], with places X,Y,Z in mm";

std::vector<std::string> SplitAt(char separator, const std::string& word)
{
  std::vector<std::string> parts;
  std::istringstream stream(word);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

double NumberIn(const std::string& option, const std::string& word)
{
  const std::optional<double> number = ParseNumber(word);
  if (!number || !std::isfinite(*number))
  {
    throw InputError(option + ": \"" + word + "\" is no number");
  }
  return *number;
}

SurfacePull ParsePull(const std::string& word)
{
  const std::vector<std::string> parts = SplitAt(':', word);
  if (parts.size() < 2 || parts.size() > 3)
  {
    throw InputError("--pull " + word + " is not " + PullForm);
  }
  SurfacePull pull;
  pull.PlaceWorld = ParseVector("--pull", parts[0]);
  if (parts[1].find(',') != std::string::npos)
  {
    pull.TargetWorld = ParseVector("--pull", parts[1]);
  }
  else
  {
    pull.Displacement = NumberIn("--pull", parts[1]);
  }
  if (parts.size() == 3)
  {
    const std::vector<std::string> widths = SplitAt('+', parts[2]);
    if (widths.empty() || widths.size() > 2)
    {
      throw InputError("--pull " + word + " has more than two widths");
    }
    pull.Width = NumberIn("--pull", widths[0]);
    pull.SecondWidth = widths.size() == 2 ? NumberIn("--pull", widths[1]) : 0.0;
  }
  return pull;
}

PlaneCut ParseCut(const std::string& word)
{
  const std::vector<std::string> parts = SplitAt(':', word);
  if (parts.size() != 2)
  {
    throw InputError("--cut " + word + " is not POINT:NORMAL, each X,Y,Z");
  }
  return {ParseVector("--cut", parts[0]), ParseVector("--cut", parts[1])};
}

BrushStroke ParseStroke(const std::string& option, const std::string& word)
{
  const std::vector<std::string> parts = SplitAt(':', word);
  if (parts.size() < 2)
  {
    throw InputError(option + " " + word + " is not X,Y,Z[:X,Y,Z...]:RADIUS");
  }
  BrushStroke::Path path;
  for (std::size_t n = 0; n + 1 < parts.size(); ++n)
  {
    path.push_back(ParseVector(option, parts[n]));
  }
  BrushStroke stroke;
  stroke.PointsWorld = std::make_shared<const BrushStroke::Path>(std::move(path));
  stroke.Radius = NumberIn(option, parts.back());
  stroke.Erases = option == "--erase";
  return stroke;
}

std::string TextOf(const CorrectedOrgan& organ)
{
  TextTable table;
  table.AddRow({"steps", std::to_string(organ.Steps.size())});
  table.AddRow({"volume", FixedText(organ.StartMilliliters, 2) + " to " +
                              FixedText(organ.Milliliters, 2) + " ml"});
  table.AddRow({"Dice with the start", FixedText(organ.Dice, 4)});
  table.AddRow({"moved", "mean " + FixedText(organ.MeanDistance, 2) + ", largest " +
                             FixedText(organ.LargestDistance, 2) + " mm"});
  if (organ.Mask)
  {
    table.AddRow({"voxels", std::to_string(organ.AddedVoxels) + " added, " +
                                std::to_string(organ.RemovedVoxels) + " removed"});
  }
  return table.Text();
}

NeighborPolicy PolicyOf(const std::string& word)
{
  if (word == "overlap")
  {
    return NeighborPolicy::Overlap;
  }
  return word == "overwrite" ? NeighborPolicy::Overwrite : NeighborPolicy::Stop;
}
} // namespace

std::string CorrectCommand::Examples() const
{
  return "  palpate correct mask.nii.gz --pull 12,-30,41:4 --output corrected\n"
         "  palpate correct mask.nii.gz --pull 12,-30,41:4:6 --pull=-9,2,15:-2.5:5+11 --json\n"
         "  palpate correct mask.nii.gz --islands --fill --smooth 1 --output corrected\n"
         "  palpate correct mask.nii.gz --paint 12,-30,41:12,-24,41:5 --erase=-9,2,15:3\n"
         "  palpate correct mask.nii.gz --steps corrected/corrections.json --output again\n"
         "  palpate correct model.json --pull 12,-30,41:13,-34,44 --output corrected";
}

void CorrectCommand::DeclareOptions(CLI::App& app)
{
  this->Declared = &app;
  app.add_option("FILE", this->Inputs.File,
                 "A segmentation, or a model (" + ListOfEndings(ReadableModelEndings()) + ")")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--label", this->Label, "The structure of a segmentation that has several")
      ->type_name("N|NAME");
  app.add_option("--pull", this->Pulls,
                 std::string("Moves the surface outwards at the point of it that is nearest to a "
                             "place, inwards below 0, or to a target: ") +
                     PullForm +
                     ", patient LPS. The width (mm, default 8) is the standard "
                     "deviation of the Gaussian along the surface; W1+W2: the mean of "
                     "two. Former pulls' places stay. May be repeated, as the next seven")
      ->type_name("PULL")
      ->allow_extra_args(false);
  app.add_flag("--islands", "Removes all but the largest part of the mask");
  app.add_flag("--fill", "Fills the mask's cavities");
  app.add_option("--smooth", this->Smooths,
                 "Smooths the mask by a Gaussian of this standard deviation; its size stays")
      ->type_name("MM")
      ->allow_extra_args(false);
  app.add_option("--cut", this->Cuts,
                 "Removes what lies beyond a plane through a point (mm), where its normal points "
                 "to: X,Y,Z:X,Y,Z")
      ->type_name("CUT")
      ->allow_extra_args(false);
  app.add_option("--paint", this->Paints,
                 "Adds the voxels whose centres are within a radius (mm) of a path: "
                 "X,Y,Z[:X,Y,Z...]:RADIUS")
      ->type_name("STROKE")
      ->allow_extra_args(false);
  app.add_option("--erase", this->Erasures, "Removes them: X,Y,Z[:X,Y,Z...]:RADIUS")
      ->type_name("STROKE")
      ->allow_extra_args(false);
  app.add_option("--steps", this->Lists, "Does the steps of a corrections.json, as if given here")
      ->check(FileType::Input("file", ".json"))
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--neighbours", this->Neighbors,
                 "What is added does at other structures: stop, overlap (in a layer of its own) or "
                 "overwrite")
      ->check(CLI::IsMember({"stop", "overlap", "overwrite"}))
      ->capture_default_str();
  this->Images.Declare(app, "folder");
  app.add_option("--output", this->Output,
                 "Folder for the corrected mask.nii.gz, mask.seg.nrrd or model.json, change.vtp "
                 "with distances from the start, correction.json, and corrections.json for --steps "
                 "(default: write nothing)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({"mask.nii.gz", "mask.seg.nrrd", "model.json", "change.vtp",
                                      "correction.json", "corrections.json"}));
  app.add_flag("--json", this->Json, "Print one JSON object");
}

std::vector<CorrectionStep> CorrectCommand::Steps() const
{
  std::vector<CorrectionStep> steps;
  std::map<std::string, std::size_t> taken;
  for (const CLI::Option* option : this->Declared->parse_order())
  {
    const std::string name = option->get_name();
    const auto next = [&](const std::vector<std::string>& words) { return words[taken[name]++]; };
    if (name == "--pull")
    {
      steps.emplace_back(ParsePull(next(this->Pulls)));
    }
    else if (name == "--islands")
    {
      steps.emplace_back(IslandRemoval{});
    }
    else if (name == "--fill")
    {
      steps.emplace_back(CavityFilling{});
    }
    else if (name == "--smooth")
    {
      steps.emplace_back(SurfaceSmoothing{NumberIn(name, next(this->Smooths))});
    }
    else if (name == "--cut")
    {
      steps.emplace_back(ParseCut(next(this->Cuts)));
    }
    else if (name == "--paint" || name == "--erase")
    {
      steps.emplace_back(
          ParseStroke(name, next(name == "--paint" ? this->Paints : this->Erasures)));
    }
    else if (name == "--steps")
    {
      const std::vector<CorrectionStep> read = ReadCorrections(next(this->Lists));
      steps.insert(steps.end(), read.begin(), read.end());
    }
  }
  return steps;
}

CorrectedOrgan CorrectCommand::Correct(Console& console)
{
  const std::vector<CorrectionStep> steps = this->Steps();
  if (steps.empty())
  {
    throw InputError(
        "there is nothing to correct; give --pull, --islands, --fill, --smooth, --cut, "
        "--paint, --erase or --steps");
  }
  if (IsModelFile(this->Inputs.File))
  {
    return CorrectedOrgan::OfModel(ReadModel(this->Inputs.File), steps);
  }
  const Segmentation segmentation = ReadSegmentation(this->Inputs.File, this->Images.Choice());
  for (const std::string& note : segmentation.Remarks())
  {
    console.Note(this->Inputs.File.string() + ": " + note);
  }
  if (this->Label.empty() && segmentation.Segments.size() > 1)
  {
    throw InputError(this->Inputs.File.string() + " has " +
                     std::to_string(segmentation.Segments.size()) +
                     " structures; choose one with --label");
  }
  this->Inputs.Structure =
      this->Label.empty() ? segmentation.Segments.front() : segmentation.Find(this->Label);
  this->Inputs.Neighbors = PolicyOf(this->Neighbors);
  return CorrectedOrgan::OfMask(segmentation, *this->Inputs.Structure, steps,
                                this->Inputs.Neighbors);
}

int CorrectCommand::Run(Console& console)
{
  const Interruption interruption;
  if (!this->Output.empty())
  {
    CheckOutputFolder(this->Output);
  }
  const CorrectedOrgan organ = this->Correct(console);
  if (!this->Output.empty())
  {
    WriteCorrectionFiles(organ, this->Inputs, this->Output, ProgramVersion());
  }
  console.Output() << (this->Json
                           ? CorrectionJson(organ, this->Inputs, this->Output.string()) + "\n"
                           : TextOf(organ));
  return 0;
}
} // namespace palpate::cli
