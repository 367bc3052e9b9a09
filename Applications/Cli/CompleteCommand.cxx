#include "CompleteCommand.h"

#include "Console.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
#include "KnownOrgan.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"
#include "Refusal.h"
#include "ShapePriorFile.h"
#include "TextTable.h"
#include "TouchedPointsFile.h"
#include "VectorText.h"
#include "VolumeFile.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <utility>

namespace palpate::cli
{
namespace
{
constexpr int NextTouchCount = 6;

std::string PlaceText(const Vector3& place)
{
  return FixedText(place[0], 1) + ", " + FixedText(place[1], 1) + ", " + FixedText(place[2], 1);
}

std::string TextOf(const CompletedOrgan& organ)
{
  TextTable table;
  table.AddRow({"touches", std::to_string(organ.Touches) + ", RMS " +
                               FixedText(organ.Found.Distance, 2) + " mm from the surface (limit " +
                               FixedText(organ.Found.LargestDistance, 2) + ")"});
  table.AddRow({"prior", organ.Found.PriorCases > 0
                             ? std::to_string(organ.Found.PriorCases) + " cases"
                             : "smoothness alone"});
  table.AddRow({"centre", PlaceText(CenterOf(organ.Found.Model)) + " mm"});
  table.AddRow({"volume", FixedText(organ.Milliliters, 1) + " ml"});
  table.AddRow({"standard deviation", "RMS " + FixedText(organ.MeanDeviation, 2) + ", largest " +
                                          FixedText(organ.LargestDeviation, 2) + " mm"});
  for (std::size_t n = 0; n < organ.Found.Next.size(); ++n)
  {
    table.AddRow({n == 0 ? "touch next" : "", PlaceText(organ.Found.Next[n]) + " mm"});
  }
  return table.Text();
}
} // namespace

std::string CompleteCommand::Examples() const
{
  return "  palpate complete touched.csv --output out            by smoothness alone\n"
         "  palpate complete touched.mrk.json --prior prior.json --output out\n"
         "  palpate complete touched.csv --prior prior.json --grid t2.nii.gz --output out\n"
         "                                                       also as a mask\n"
         "  palpate complete touched.csv --prior zone.json --known gland/model.json --output out\n"
         "                                                       an organ in or at a known one\n"
         "  palpate complete --prior prior.json --center 2,-10,31   where to touch first";
}

void CompleteCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("POINTS", this->Inputs.Points,
                 "Touched points, mm, patient LPS (" + ListOfEndings(TouchedPointsEndings()) +
                     "): a table with columns x, y, z and perhaps nx, ny, nz, sd, stroke and "
                     "outside, or markups of 3D Slicer, whose curves are strokes, or a recorded "
                     "touch")
      ->check(FileType::Input("file"));
  app.add_option("--prior", this->Inputs.Prior,
                 "What is known of the organ, as cohort --prior wrote it (default: that it is "
                 "smooth)")
      ->type_name("FILE")
      ->check(FileType::Input("file", ".json"));
  CLI::Option* known =
      app.add_option("--known", this->Inputs.Known,
                     "The other organ that a prior of cohort --known relates to: its model, or a "
                     "segmentation")
          ->type_name("FILE")
          ->check(FileType::Input("label"));
  app.add_option("--known-label", this->KnownLabel,
                 "Structure of --known, by number or name, if there are several")
      ->type_name("N|NAME")
      ->needs(known);
  app.add_option("--sigma", this->Inputs.Sigma,
                 "Standard deviation of a touched point from the surface, mm")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.01, 100.0))
      ->capture_default_str();
  app.add_option("--tool-radius", this->ToolRadius, "Of the sphere that touched in a recording, mm")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--center", this->Center,
                 "A point near the organ's centre, mm, patient LPS (default: the middle of the "
                 "points)")
      ->type_name("X,Y,Z")
      ->excludes(known);
  app.add_option("--grid", this->Grid, "Image on whose voxels mask.nii.gz is written, too")
      ->type_name("IMAGE")
      ->check(FileType::Input("image"));
  this->Images.Declare(app, "folder");
  app.add_option("--output", this->Output,
                 "Folder for model.json, model.vtp with standard deviations, completion.json and "
                 "mask.nii.gz (default: write nothing)")
      ->type_name("DIR")
      ->check(
          FileType::OutputFolder({"model.json", "model.vtp", "completion.json", "mask.nii.gz"}));
  app.add_flag("--json", this->Json, "Print one JSON object");
}

OrganCompletion CompleteCommand::Complete(std::size_t& count) const
{
  CompletionRequest request;
  request.Frequency = CompletedOrgan::Frequency;
  request.NextCount = NextTouchCount;
  if (!this->Inputs.Points.empty())
  {
    request.Touches = ReadTouchedPoints(this->Inputs.Points, this->Inputs.Sigma, this->ToolRadius);
  }
  if (!this->Center.empty())
  {
    request.ClickWorld = ParseVector("--center", this->Center);
  }
  if (request.Touches.empty() && !request.ClickWorld && this->Inputs.Known.empty())
  {
    throw InputError("there are no touched points; give a file of them, or --center to learn where "
                     "to touch first");
  }
  if (!this->Inputs.Prior.empty())
  {
    request.Prior = ReadOrganPrior(this->Inputs.Prior);
  }
  if (!this->Inputs.Known.empty())
  {
    request.Known = ReadKnownOrgan(this->Inputs.Known, this->KnownLabel, this->Images.Choice());
  }
  OrganCompletion made;
  RequireInput(CompleteOrgan(request, made), this->Inputs.Points.string());
  count = request.Touches.size();
  return made;
}

int CompleteCommand::Run(Console& console)
{
  const Interruption interruption;
  if (this->Output.empty() && !this->Grid.empty())
  {
    throw InputError("--grid is for the mask in --output; give a folder");
  }
  if (!this->Output.empty())
  {
    CheckOutputFolder(this->Output);
  }
  if (!this->Grid.empty())
  {
    this->Inputs.Grid = ReadVolume(this->Grid, this->Images.Choice()).Image;
  }
  std::size_t count = 0;
  OrganCompletion completion = this->Complete(count);
  if (!completion.Judgement.IsOk())
  {
    console.Error(this->Inputs.Points.string() + ": " + completion.Judgement.Message() +
                  "; outline it and use palpate fit");
    return 1;
  }
  const CompletedOrgan organ = CompletedOrgan::Of(std::move(completion), count);
  if (!this->Output.empty())
  {
    WriteCompletionFiles(organ, this->Inputs, this->Output, ProgramVersion());
  }
  console.Output() << (this->Json
                           ? CompletionJson(organ, this->Inputs, this->Output.string()) + "\n"
                           : TextOf(organ));
  return 0;
}
} // namespace palpate::cli
