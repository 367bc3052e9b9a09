#include "RegisterCommand.h"

#include "Console.h"
#include "FileFormat.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "ImageFormat.h"
#include "InputError.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "RegistrationText.h"
#include "StudyMarkups.h"
#include "StudyMarkupsReader.h"
#include "SurfaceFile.h"
#include "TransformFile.h"

#include <CLI/CLI.hpp>
#include <ostream>

namespace palpate::cli
{
namespace
{
NamedPoints PointsOf(const std::filesystem::path& file)
{
  NamedPoints points;
  for (const StudyLandmark& one : ReadMarkups(file).Landmarks)
  {
    points.Names.push_back(one.Name);
    points.Points.push_back(one.PositionWorld);
  }
  return points;
}

RegisteredSide SideOf(const std::filesystem::path& file)
{
  RegisteredSide side{file, {}};
  if (IsMarkupsFile(file))
  {
    side.Points = PointsOf(file);
  }
  return side;
}

RegistrationKind KindOf(const std::string& word)
{
  return word == "rigid"        ? RegistrationKind::Rigid
         : word == "similarity" ? RegistrationKind::Similarity
                                : RegistrationKind::Affine;
}
} // namespace

std::string RegisterCommand::Examples() const
{
  return "  palpate register before.json after.json --output moved.tfm     two surfaces or models\n"
         "  palpate register atlas.nii.gz scan.nii.gz --label 3 --kind similarity\n"
         "  palpate register model.json touched.mrk.json --noise 1         points that were "
         "touched\n"
         "  palpate register a.mrk.json b.mrk.json --output a-to-b.lta     landmarks\n"
         "  palpate register t1.nii.gz t2.nii.gz --images --output t1-to-t2.mat";
}

void RegisterCommand::DeclareOptions(CLI::App& app)
{
  const std::string kinds = "segmentation, surface (" +
                            ListOfEndings(SurfaceFormats().ReadEndings()) + "), model (" +
                            ListOfEndings(ReadableModelEndings()) + ") or points (.mrk.json)";
  app.add_option("MOVING", this->Moving, "What is moved: " + kinds)
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("FIXED", this->Fixed, "Where it belongs: the same kinds")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--kind", this->Kind, "What may change: place and turn, size too, or any shear")
      ->check(CLI::IsMember({"rigid", "similarity", "affine"}))
      ->capture_default_str();
  app.add_option("--label", this->Settings.Label, "Structure of a segmentation")
      ->type_name("N|NAME");
  app.add_option("--fixed-label", this->Settings.FixedLabel, "Structure of FIXED, if it is another")
      ->type_name("N|NAME");
  app.add_option("--moving-landmarks", this->MovingLandmarks,
                 "Landmarks of MOVING to start from (.mrk.json)")
      ->check(FileType::Input("file", ".mrk.json"));
  app.add_option("--fixed-landmarks", this->FixedLandmarks,
                 "Their partners of FIXED, by name or order (.mrk.json)")
      ->check(FileType::Input("file", ".mrk.json"));
  app.add_flag("--images", this->Settings.IsOfImages,
               "Both are images, matched by their values (mutual information)");
  app.add_option("--initial", this->Initial,
                 "Transform to start from: " + ListOfEndings(TransformEndings()))
      ->type_name("FILE")
      ->check(FileType::Input("file"));
  app.add_option("--start", this->Start,
                 "Start without landmarks and --initial: centroids on each other (bodies by "
                 "default), or as they lie (images by default)")
      ->check(CLI::IsMember({"centroids", "frame"}));
  app.add_option("--noise", this->Settings.Noise,
                 "Standard deviation of points, mm (default: judged by what remains)")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, 100.0));
  this->Images.Declare(app, "folder");
  this->Images.DeclareValues(app);
  app.add_option("--output", this->Output,
                 "Transform to write: " + ListOfEndings(TransformEndings()) +
                     " (default: write nothing)")
      ->type_name("FILE")
      ->check(FileType::Output("file"));
  app.add_flag("--json", this->Json, "Print one JSON object");
}

FileRegistrationSettings RegisterCommand::ReadSettings() const
{
  FileRegistrationSettings settings = this->Settings;
  settings.Kind = KindOf(this->Kind);
  settings.StartsAtCentroids =
      this->Start.empty() ? !settings.IsOfImages : this->Start == "centroids";
  settings.Images = this->Images.Choice();
  if (!this->Initial.empty())
  {
    settings.Start = ReadTransform(this->Initial, this->TransformFrames());
  }
  if (this->MovingLandmarks.empty() != this->FixedLandmarks.empty())
  {
    throw InputError("--moving-landmarks and --fixed-landmarks belong together; give both");
  }
  if (!this->MovingLandmarks.empty())
  {
    settings.MovingLandmarks = PointsOf(this->MovingLandmarks);
    settings.FixedLandmarks = PointsOf(this->FixedLandmarks);
  }
  return settings;
}

// FLIRT's matrices are in the frames of images.
TransformImages RegisterCommand::TransformFrames() const
{
  const auto imageOf = [](const std::filesystem::path& file)
  { return EndingOf(file, ReadableImageEndings()).empty() ? std::filesystem::path() : file; };
  return {imageOf(this->Moving), imageOf(this->Fixed)};
}

int RegisterCommand::Run(Console& console)
{
  const Interruption interruption;
  if (!this->Output.empty() && EndingOf(this->Output, TransformEndings()).empty())
  {
    throw InputError("--output " + this->Output.string() +
                     " is no transform by its name; name it " + ListOfEndings(TransformEndings()) +
                     ".");
  }
  const RegisteredSide moving = SideOf(this->Moving);
  const RegisteredSide fixed = SideOf(this->Fixed);
  if (moving.Points && fixed.Points && (!this->Initial.empty() || this->Settings.IsOfImages))
  {
    throw InputError("--initial and --images mean nothing for two lists of points; leave them out");
  }
  const FileRegistration found = RegisterFiles(moving, fixed, this->ReadSettings(),
                                               [&](double fraction, const std::string& stage)
                                               {
                                                 console.Progress(fraction, stage);
                                                 return !Interruption::WasAsked();
                                               });
  console.EndProgress();
  if (!this->Output.empty())
  {
    WriteTransform(this->Output, found.Map, this->TransformFrames());
  }
  for (const std::string& note : found.Notes)
  {
    console.Note(note);
  }
  console.Output() << (this->Json
                           ? RegistrationJson(found, moving, fixed, this->Output.string()) + "\n"
                           : RegistrationText(found));
  return 0;
}
} // namespace palpate::cli
