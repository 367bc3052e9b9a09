#include "TouchCommand.h"

#include "CancelDeadline.h"
#include "CommandProgress.h"
#include "Console.h"
#include "ContactLimits.h"
#include "DecimalText.h"
#include "DeviceOption.h"
#include "DrillExport.h"
#include "DrillState.h"
#include "EarlierFiles.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "FitStructure.h"
#include "ImageFormat.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "Interruption.h"
#include "JsonSchema.h"
#include "MaskFolders.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "OutputNames.h"
#include "SceneFile.h"
#include "SceneRepresentation.h"
#include "ScreenText.h"
#include "SurfaceFile.h"
#ifdef PALPATE_HAS_NETWORK
#include "TouchPeer.h"
#endif
#include "TouchReport.h"
#include "Units.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iomanip>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr int NotWritten = 2; // as for every refused output

// Prints the error if not.
bool IsWritten(const std::function<void()>& write, Console& console)
{
  try
  {
    write();
    return true;
  }
  catch (const InputError& error)
  {
    console.EndProgress();
    console.Error(error.what());
    return false;
  }
}

// 3D Slicer passes every option, also one with its default.
bool IsChanged(const CLI::Option& option)
{
  if (option.count() == 0)
  {
    return false;
  }
  const std::string& given = option.results().back();
  const std::string standard = option.get_default_str();
  const std::optional<double> number = ParseNumber(given);
  const std::optional<double> standardNumber = ParseNumber(standard);
  return number && standardNumber ? *number != *standardNumber : given != standard;
}

std::vector<std::string> Representations()
{
  std::vector<std::string> names;
  for (const SceneRepresentation& representation : SceneRepresentations())
  {
    names.push_back(representation.Name);
  }
  return names;
}

// "left.nii.gz", 2, "bone" gives "left-2-bone.nii.gz".
std::filesystem::path WithNumberAndName(const std::filesystem::path& path, std::size_t number,
                                        const std::string& name)
{
  const std::string stem = CaseNameOf(path);
  const std::string ending = path.filename().string().substr(stem.size());
  return path.parent_path() /
         (stem + "-" + std::to_string(number) + "-" + PlainName(name) + ending);
}
} // namespace

std::string TouchCommand::Examples() const
{
  return "  palpate touch case1/model.json                   a sweep around a fitted model\n"
         "  palpate touch mask.seg.nrrd --label 1 --tool-radius 3 --output felt\n"
         "  palpate touch ct.nrrd --iso 300 --stiffness 1 --rate 2000\n"
         "  palpate touch ct.nrrd --iso 300 --wear 0.05 --drill strokes.json --output drilled\n"
         "  palpate touch knee.scene.json --path hand.csv --real-time --output felt\n"
#ifdef PALPATE_HAS_NETWORK
         "  palpate touch knee.scene.json --real-time --igtl 18944   shown in 3D Slicer\n"
#endif
         "  palpate touch felt/scene.json --replay felt/session.touch";
}

void TouchCommand::DeclareStructure(CLI::App& app)
{
  app.add_option("--label", this->Labels,
                 "Structures of segmentations by number or name (default: all)")
      ->type_name("N|NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--iso", this->Iso,
                 "Treat the files as images, and touch the iso-surface of this value")
      ->expected(1)
      ->check(FiniteNumber::Any());
  app.add_option("--representation", this->Representation,
                 "Touch model of the structures (automatic: harmonics for models, facets for "
                 "surfaces, sub-voxel for voxels)")
      ->check(CLI::IsMember(Representations()))
      ->capture_default_str();
  app.add_option("--degree", this->Structure.Degree,
                 "Degree of the harmonics fitted to segmentations")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  app.add_option("--mode", this->Mode,
                 "Contact of harmonics: nearest point, or the published radial law")
      ->check(CLI::IsMember({"nearest", "radial"}))
      ->capture_default_str();
  app.add_option("--interpolation", this->Interpolation,
                 "Interpolation between voxels: linear, or cubic (smoother, slower)")
      ->check(CLI::IsMember({"linear", "cubic"}))
      ->capture_default_str();
  app.add_option("--smoothing", this->Structure.Smoothing,
                 "Smoothing of sub-voxel structures, in voxels")
      ->check(FiniteNumber::Between(0.0, 8.0))
      ->capture_default_str();
  app.add_flag("--keep-cuts", this->Structure.KeepsCuts,
               "Feel where the border of an image cuts a label as if the structure ended there; "
               "otherwise the tool passes there without force");
  app.add_option("--stiffness", this->Structure.Stiffness,
                 "Stiffness, N per mm of hand displacement")
      ->type_name("N/MM")
      ->check(FiniteNumber::Between(0.0, ContactLimits::Stiffness))
      ->capture_default_str();
  app.add_option("--damping", this->Structure.Damping, "Damping, N s/mm")
      ->type_name("NS/MM")
      ->check(FiniteNumber::Between(0.0, ContactLimits::Damping))
      ->capture_default_str();
  app.add_option("--friction", this->Structure.Friction.Static,
                 "Coefficient of static friction; sliding friction is 0.8 of it")
      ->check(FiniteNumber::Between(0.0, ContactLimits::Friction))
      ->capture_default_str();
  app.add_option("--wear", this->Structure.Drill.Wear,
                 "Wear of sub-voxel structures under the drill, in mm per N of push and m of "
                 "rubbing (0: not drilled)")
      ->check(FiniteNumber::Between(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--tool-radius", this->Tool.Radius, "Radius of the tool, mm (0: a point)")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, ContactLimits::ToolRadius))
      ->capture_default_str();
  CLI::Option* const length =
      app.add_option("--tool-length", this->ToolLength,
                     "Length of a capsule's axis, which tips where it touches, mm (0: a sphere)")
          ->type_name("MM")
          ->check(FiniteNumber::Between(0.0, 1000.0))
          ->capture_default_str();
  app.add_option(
         "--tool-shaft", this->ToolShaft,
         "Radius of the shaft of a drill or needle, whose ball has --tool-radius, and which "
         "is --tool-length long, mm (0: no shaft)")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, ContactLimits::ToolRadius))
      ->needs(length)
      ->capture_default_str();
  app.add_option(
         "--tool-points", this->Tool.Points,
         "Points on the tool's surface for sub-voxel structures (0: from voxel size and radius)")
      ->check(CLI::Range(0, ToolShape::MaximumCount))
      ->capture_default_str();
}

void TouchCommand::DeclareRun(CLI::App& app)
{
  app.add_option("--device", this->Device,
                 "Haptic device, see palpate devices (default: the scene's, or simulated)")
      ->type_name("NAME");
  app.add_option("--firmware", this->Firmware, "Firmware file, for devices that need it")
      ->type_name("FILE")
      ->check(FileType::Input("file"));
  app.add_option("--rate", this->Rate, "Servo rate, Hz (default: the scene's, or 1000)")
      ->type_name("HZ")
      ->check(FiniteNumber::Between(1.0, 1e5));
  app.add_option("--scale", this->Scale,
                 "Scene mm per mm of hand movement (default: the whole scene is in reach)")
      ->expected(1)
      ->check(FiniteNumber::Between(1e-3, 1e3));
  app.add_option("--path", this->PathFile,
                 "Target path of a simulated hand, time_s,x_mm,y_mm,z_mm per line (default: a "
                 "sweep around the scene)")
      ->type_name("CSV")
      ->check(FileType::Input("file", ".csv"));
  app.add_option("--depth", this->Sweep.SweepDepth, "Depth of the sweep below the surface, mm")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--speed", this->Sweep.SweepSpeed, "Speed of the sweep, mm/s")
      ->type_name("MM/S")
      ->check(FiniteNumber::Between(0.1, 1e5))
      ->capture_default_str();
  app.add_option("--drill", this->DrillScript,
                 "Scripted pedal and button actions for drilling, as JSON (see "
                 "Documentation/HowTo/Drill.md)")
      ->type_name("FILE")
      ->check(FileType::Input("file", ".json"));
  app.add_option("--drill-state", this->DrillStateFile,
                 "Start from an earlier state of drilling (drill.state of an output folder)")
      ->type_name("FILE")
      ->check(FileType::Input("file", ".state"));
  app.add_option("--drilled", this->DrilledFiles,
                 "Write what is left after drilling: a volume (" +
                     ListOfEndings(ImageFormats().WrittenEndings()) + ") or a surface (" +
                     ListOfEndings(SurfaceFormats().WrittenEndings()) +
                     "); with several structures, their names are added to the file name")
      ->type_name("FILE")
      ->check(FileType::Output("file"))
      ->allow_extra_args(false);
  app.add_option("--seconds", this->Seconds, "Duration, s (default: that of the path)")
      ->type_name("S")
      ->expected(1)
      ->check(FiniteNumber::Between(0.001, 36000.0));
  app.add_flag("--real-time", this->IsRealTime,
               "Run at the servo rate on a separate thread; otherwise as fast as possible");
#ifdef PALPATE_HAS_NETWORK
  app.add_option("--igtl", this->Peer,
                 "Show the touch in 3D Slicer or another program by OpenIGTLink; PORT: wait for it "
                 "on this machine, *:PORT: on any; HOST:PORT: connect")
      ->type_name("PEER");
#endif
}

void TouchCommand::DeclareOptions(CLI::App& app)
{
  app.add_option(
         "FILE", this->Inputs,
         "A scene (.scene.json), or models, surfaces, segmentations or a folder of them, images "
         "with --iso")
      ->required()
      ->check(FileType::Input("file"));
  const auto before = static_cast<std::ptrdiff_t>(app.get_options().size());
  this->DeclareStructure(app);
  const std::vector<CLI::Option*> declared = app.get_options();
  this->StructureOptions.assign(declared.begin() + before, declared.end());
  this->DeclareRun(app);
  app.add_option("--output", this->OutputFolder,
                 "Folder for report.html, summary.json, scene.json and session.touch")
      ->type_name("DIR")
      ->check(FileType::OutputFolder(
          {"report.html", "summary.json", "scene.json", "session.touch", "drill.state"}));
  CLI::Option* replay =
      app.add_option("--replay", this->ReplayFile,
                     "Replay a recorded session (session.touch), and compare each tick's force")
          ->type_name("FILE")
          ->check(FileType::Input("file", ".touch"));
  for (const char* ofTheHand : {"--seconds", "--real-time", "--path"})
  {
    replay->excludes(app.get_option(ofTheHand));
  }
  app.add_flag("--json", this->Json, "Print the summary as one JSON object");
}

SceneSettings TouchCommand::Settings() const
{
  SceneSettings settings;
  const bool isScene = IsSceneFile(this->Inputs.front());
  if (isScene && this->Inputs.size() > 1)
  {
    throw InputError(this->Inputs.front() + " is a complete scene; list the other files in it");
  }
  if (isScene)
  {
    for (const CLI::Option* option : this->StructureOptions)
    {
      if (IsChanged(*option))
      {
        throw InputError(option->get_name() + " has no effect on a scene; state it in " +
                         this->Inputs.front());
      }
    }
    settings = ReadScene(this->Inputs.front());
  }
  else
  {
    settings.Tool = this->Tool;
    if (this->ToolLength > 0.0)
    {
      settings.Tool.Kind = this->ToolShaft > 0.0 ? TouchToolSettings::Shape::Drill
                                                 : TouchToolSettings::Shape::Capsule;
      settings.Tool.Length = this->ToolLength;
      settings.Tool.ShaftRadius = this->ToolShaft;
    }
    // Without a segmentation the scene tells that it has no use for labels.
    const bool hasLabels =
        this->Iso.empty() && std::any_of(this->Inputs.begin(), this->Inputs.end(),
                                         [](const std::string& input)
                                         { return !IsModelFile(input) && !IsSurfaceFile(input); });
    for (const std::string& input : this->Inputs)
    {
      SceneStructure structure = this->Structure;
      structure.File = input;
      structure.Labels = structure.Source() == SceneSource::Label || !hasLabels
                             ? this->Labels
                             : std::vector<std::string>();
      structure.Representation = this->Representation;
      structure.Mode =
          this->Mode == "radial" ? RadialContactMode::Radial : RadialContactMode::Nearest;
      structure.Interpolation = this->Interpolation == "cubic" ? FieldInterpolation::TricubicBSpline
                                                               : FieldInterpolation::Trilinear;
      constexpr double DynamicPart = 0.8;
      structure.Friction.Dynamic = DynamicPart * structure.Friction.Static;
      if (!this->Iso.empty())
      {
        structure.Iso = this->Iso.front();
      }
      settings.Structures.push_back(structure);
    }
  }
  settings.Device = this->Device.empty() ? settings.Device : this->Device;
  settings.Device = this->Firmware.empty()
                        ? settings.Device
                        : WithDeviceOption(settings.Device, "firmware", this->Firmware);
  settings.Rate = this->Rate > 0.0 ? this->Rate : settings.Rate;
  if (!this->Scale.empty())
  {
    settings.Placement.Scale = this->Scale.front();
  }
  return settings;
}

TouchScript TouchCommand::Script() const
{
  TouchScript script = this->Sweep;
  if (!this->PathFile.empty())
  {
    script.Path = ReadHandPath(this->PathFile);
  }
  if (!this->DrillScript.empty())
  {
    script.Actions = ReadDrillScript(this->DrillScript);
  }
  if (!this->Seconds.empty())
  {
    script.Duration = this->Seconds.front();
  }
  return script;
}

void TouchCommand::PrintSummary(const PreparedTouch& touch, const TouchResult& result, bool hasPage,
                                Console& console) const
{
  if (this->Json)
  {
    console.Output() << TouchSummaryText(touch, result);
    return;
  }
  constexpr double Almost = 0.999;
  std::ostream& out = console.Output();
  for (std::size_t s = 0; s < touch.Structures.size(); ++s)
  {
    out << Printable(touch.Structures[s].Touch.Name + ": " + touch.Structures[s].Represented)
        << ", touched for " << std::fixed << std::setprecision(2) << result.TouchedSeconds[s]
        << " s\n";
  }
  out << result.Ticks << " ticks; at most " << result.Trace.Whole().Force.Most << " N, "
      << result.Trace.Whole().Depth.Most << " mm deep; a tick takes "
      << MicrosecondsPerNanosecond * static_cast<double>(result.Durations.Median())
      << " us, 99.9 % at most "
      << MicrosecondsPerNanosecond * static_cast<double>(result.Durations.Quantile(Almost))
      << " us\n";
  if (result.BeyondLinearSeconds > 0.0)
  {
    out << "for " << result.BeyondLinearSeconds
        << " s beyond linear elasticity, where the force is an estimate\n";
  }
  for (const std::string& line : DrillLines(touch, result))
  {
    out << Printable(line) << '\n';
  }
  if (hasPage)
  {
    out << Printable((this->OutputFolder / "report.html").string()) << '\n';
  }
}

int TouchCommand::Replay(const PreparedTouch& touch, Console& console) const
{
  const TouchComparison comparison = CompareTouch(touch, this->ReplayFile);
  if (this->Json)
  {
    const nlohmann::ordered_json object{{JsonSchemaKey, JsonSchemaVersion},
                                        {"ticks", comparison.Ticks},
                                        {"different_ticks", comparison.DifferentTicks},
                                        {"force_difference_max_n", comparison.LargestDifference}};
    console.Output() << object.dump() << '\n';
  }
  else
  {
    console.Output() << comparison.DifferentTicks << " of " << comparison.Ticks
                     << " ticks differ, forces by at most " << comparison.LargestDifference
                     << " N\n";
  }
  if (!this->OutputFolder.empty() && touch.Drill != nullptr)
  {
    MakeOutputFolder(this->OutputFolder);
  }
  if (!this->WriteDrilled(touch, console))
  {
    return NotWritten;
  }
  return comparison.DifferentTicks == 0 ? 0 : 1;
}

void TouchCommand::CheckDrilled(const PreparedTouch& touch) const
{
  if (touch.Drill == nullptr && (!this->DrilledFiles.empty() || !this->DrillStateFile.empty()))
  {
    throw InputError("no structure of the scene can be drilled; give one a \"drill\" in the scene, "
                     "or a file that is no scene --wear");
  }
  for (const std::string& file : this->DrilledFiles)
  {
    if (!IsWritableImage(file) && !IsSurfaceFile(file))
    {
      throw InputError(file + " is neither a volume nor a surface file; use " +
                       ListOfEndings(ImageFormats().WrittenEndings()) + ", or " +
                       ListOfEndings(SurfaceFormats().WrittenEndings()));
    }
    for (const SceneStructure& structure : touch.Settings.Structures)
    {
      RequireOtherFile(file, structure.File);
    }
  }
}

bool TouchCommand::WriteDrilled(const PreparedTouch& touch, Console& console) const
{
  if (touch.Drill == nullptr)
  {
    return true;
  }
  bool isWhole =
      this->OutputFolder.empty() ||
      IsWritten([&] { WriteDrillState(this->OutputFolder / "drill.state", *touch.Drill); },
                console);
  const std::vector<DrillSite>& sites = touch.Drill->Sites();
  // After an interruption, what was drilled until then is still written.
  const ProgressFunction progress = [&console](double fraction, const std::string& stage)
  {
    console.Progress(fraction, stage);
    return true;
  };
  for (const std::filesystem::path file : this->DrilledFiles)
  {
    for (std::size_t site = 0; site < sites.size(); ++site)
    {
      const std::filesystem::path path =
          sites.size() > 1 ? WithNumberAndName(file, site + 1, sites[site].Name) : file;
      const int number = static_cast<int>(site);
      const auto write = [&]
      {
        IsWritableImage(path) ? WriteImage(path, DrilledImage(*touch.Drill, number, progress))
                              : WriteSurface(path, DrilledSurface(*touch.Drill, number, progress));
      };
      isWhole = IsWritten(write, console) && isWhole;
      console.EndProgress();
    }
  }
  return isWhole;
}

TouchResult TouchCommand::RunWithPeer(const PreparedTouch& touch, TouchRunSettings& settings,
                                      Console& console) const
{
#ifdef PALPATE_HAS_NETWORK
  if (!this->Peer.empty())
  {
    if (settings.IsVirtual && !touch.IsRealTimeOnly)
    {
      throw InputError("--igtl shows a touch while it runs; add --real-time");
    }
    TouchPeer peer(this->Peer, touch, console);
    settings.Watcher = [&peer](const TouchState& newest) { peer.Show(newest); };
    return RunTouch(touch, settings, ProgressOn(console));
  }
#endif
  return RunTouch(touch, settings, ProgressOn(console));
}

int TouchCommand::Touch(const PreparedTouch& touch, Console& console) const
{
  TouchRunSettings settings;
  settings.IsVirtual = !this->IsRealTime;
  settings.Guide = [&console](const std::string& message) { console.Note(message); };
  if (!this->OutputFolder.empty())
  {
    MakeOutputFolder(this->OutputFolder);
    settings.Recording = this->OutputFolder / "session.touch";
  }
  const TouchResult result = this->RunWithPeer(touch, settings, console);
  console.EndProgress();
  // An output that cannot be written does not stop the others.
  const bool hasOutput = !this->OutputFolder.empty();
  const bool hasPage =
      hasOutput && IsWritten([&] { WriteTouchFiles(this->OutputFolder, touch, result); }, console);
  const bool isWhole = this->WriteDrilled(touch, console) && hasPage == hasOutput;
  this->PrintSummary(touch, result, hasPage, console);
  if (!result.SweepNote.empty())
  {
    console.Note(result.SweepNote);
  }
  if (!result.ThreadAdvice.empty())
  {
    console.Note(result.ThreadAdvice);
  }
  if (!result.RecordingProblem.empty())
  {
    console.Error(result.RecordingProblem);
  }
  if (result.Fault != SafetyFault::None)
  {
    console.Error(std::string("forces were ") +
                  (result.HasResumed ? "interrupted" : "switched off") + ": " +
                  Describe(result.Fault, result.HasResumed) +
                  (result.DeviceProblem.empty() ? "" : " " + result.DeviceProblem));
    return 1;
  }
  if (!isWhole)
  {
    return NotWritten;
  }
  return result.RecordingProblem.empty() ? 0 : 1;
}

int TouchCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Inputs = WithMasksOfFolders(this->Inputs);
  if (!this->OutputFolder.empty())
  {
    CheckOutputFolder(this->OutputFolder);
  }
  const PreparedTouch touch = Cancellably(
      console,
      [&]
      {
        return PrepareTouch(this->Settings(), this->Script(), ProgressOn(console),
                            this->Inputs.size() > 1 ? BadMasks::LeaveOut : BadMasks::Refuse);
      });
  console.EndProgress();
  for (const std::string& reason : touch.LeftOut)
  {
    console.Error(reason);
  }
  for (const std::string& warning : touch.Warnings)
  {
    console.Note(warning);
  }
  this->CheckDrilled(touch);
  if (!this->DrillStateFile.empty())
  {
    ReadDrillState(this->DrillStateFile, *touch.Drill);
  }
  const int code =
      this->ReplayFile.empty() ? this->Touch(touch, console) : this->Replay(touch, console);
  return code == 0 && !touch.LeftOut.empty() ? 1 : code;
}
} // namespace palpate::cli
