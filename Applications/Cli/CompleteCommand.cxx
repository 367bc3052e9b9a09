#include "CompleteCommand.h"

#include "Console.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
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
  table.AddRow({"touches", std::to_string(organ.Touches) + ", RMS " + FixedText(organ.Distance, 2) +
                               " mm from the surface (limit " +
                               FixedText(organ.LargestDistance, 2) + ")"});
  table.AddRow({"prior", organ.PriorCases > 0 ? std::to_string(organ.PriorCases) + " cases"
                                              : "smoothness alone"});
  table.AddRow({"centre", PlaceText(organ.Model.CenterWorld()) + " mm"});
  table.AddRow({"volume", FixedText(organ.Milliliters, 1) + " ml"});
  table.AddRow({"standard deviation", "RMS " + FixedText(organ.MeanDeviation, 2) + ", largest " +
                                          FixedText(organ.LargestDeviation, 2) + " mm"});
  for (std::size_t n = 0; n < organ.Next.size(); ++n)
  {
    table.AddRow({n == 0 ? "touch next" : "", PlaceText(organ.Next[n]) + " mm"});
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
      ->type_name("X,Y,Z");
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

std::unique_ptr<ShapeCompletion> CompleteCommand::Complete(std::size_t& count) const
{
  std::vector<SurfaceTouch> touches;
  if (!this->Inputs.Points.empty())
  {
    touches = ReadTouchedPoints(this->Inputs.Points, this->Inputs.Sigma, this->ToolRadius);
  }
  std::optional<Vector3> center;
  if (!this->Center.empty())
  {
    center = ParseVector("--center", this->Center);
  }
  if (touches.empty() && !center)
  {
    throw InputError("there are no touched points; give a file of them, or --center to learn where "
                     "to touch first");
  }
  std::shared_ptr<const ShapePrior> prior;
  if (!this->Inputs.Prior.empty())
  {
    prior = std::make_shared<const ShapePrior>(ReadShapePrior(this->Inputs.Prior));
  }
  std::unique_ptr<ShapeCompletion> made;
  RequireInput(CompleteSurface(touches, std::move(prior), center, made),
               this->Inputs.Points.string());
  count = touches.size();
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
  const std::unique_ptr<ShapeCompletion> completion = this->Complete(count);
  if (const Status status = completion->Judge(); !status.IsOk())
  {
    console.Error(this->Inputs.Points.string() + ": " + status.Message() +
                  "; outline it and use palpate fit");
    return 1;
  }
  const CompletedOrgan organ = CompletedOrgan::Of(*completion, count, NextTouchCount);
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
