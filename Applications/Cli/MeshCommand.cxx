#include "MeshCommand.h"

#include "AvailableMemory.h"
#include "CaseFit.h"
#include "CaseText.h"
#include "CommandProgress.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileType.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "InputError.h"
#include "Interruption.h"
#include "JsonSchema.h"
#include "MaskFolders.h"
#include "OutputFolder.h"
#include "ScreenText.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"
#include "TextTable.h"
#include "Units.h"
#include "VoxelMinimum.h"
#include "vtkNew.h"
#include "vtkSegmentationSurface.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

namespace palpate::cli
{
namespace
{
using JsonObject = nlohmann::ordered_json;

void Configure(vtkSegmentationSurface* surface, const FitSettings& settings)
{
  surface->SetMethod(settings.Method == FitSettings::SurfaceMethod::Plain
                         ? vtkSegmentationSurface::PLAIN
                         : vtkSegmentationSurface::SHAPE_INTERPOLATION);
  surface->SetSmoothing(settings.Smoothing);
  surface->SetComponent(settings.Component);
}

JsonObject Describe(vtkSegmentationSurface* surface)
{
  JsonObject result;
  result["points"] = surface->GetOutput()->GetNumberOfPoints();
  result["triangles"] = surface->GetOutput()->GetNumberOfPolys();
  result["volume_ml"]["mask"] = surface->GetMaskVolume() / CubicMillimetersPerMilliliter;
  result["volume_ml"]["surface"] = surface->GetSurfaceVolume() / CubicMillimetersPerMilliliter;
  result["touches_border"] = surface->GetTouchesBorder();
  result["components"] = surface->GetNumberOfComponents();
  result["cavities"] = surface->GetCavityCount();
  return result;
}
} // namespace

std::string MeshCommand::Examples() const
{
  return "  palpate mesh mask.nii.gz --label 1 --output gland.stl\n"
         "  palpate mesh mask.seg.nrrd --label Prostate --smoothing 0 --output gland.vtp\n"
         "  palpate mesh mask.nii.gz --method plain --label 1 --output steps.ply\n"
         "  palpate mesh a.nii.gz b.nii.gz --output surfaces   every structure, one .vtp each";
}

void MeshCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("MASK", this->Inputs,
                 "Segmentations: label maps, .seg.nrrd, DICOM-SEG, or a folder of masks")
      ->required()
      ->check(FileType::Input("label"));
  this->Images.Declare(app, "folder");
  this->Images.DeclareValues(app);
  this->Options.DeclareLabels(app);
  this->Options.DeclareSurface(app);
  app.add_option("--output", this->Output,
                 "Surface file (" + ListOfEndings(SurfaceFormats().WrittenEndings()) +
                     ") for one structure, or a folder for several")
      ->type_name("FILE|DIR")
      ->check(FileType::Output("geometry"))
      ->required();
  app.add_flag("--json", this->Json, "Print one JSON object per structure");
}

bool MeshCommand::OutputIsFile() const
{
  return IsSurfaceFile(this->Output);
}

int MeshCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Settings = this->Options.Settings();
  if (this->Settings.Component == FitSettings::EachPart)
  {
    throw InputError("--component each makes several surfaces; give all, or a component's number");
  }
  this->Inputs = WithMasksOfFolders(this->Inputs);
  this->Names = CaseNames(this->Inputs);
  this->Tally = {};
  if (this->OutputIsFile() && this->Inputs.size() > 1)
  {
    throw InputError("--output " + this->Output.string() + " is one file, but there are " +
                     std::to_string(this->Inputs.size()) + " masks; give a folder.");
  }
  if (!this->OutputIsFile())
  {
    if (HasFileEnding(this->Output))
    {
      throw InputError("--output " + this->Output.string() +
                       " has the ending of no surface format; use " +
                       ListOfEndings(SurfaceFormats().WrittenEndings()) +
                       ", or for a folder a name without an ending.");
    }
    CheckOutputFolder(this->Output);
  }
  for (std::size_t file = 0; file < this->Inputs.size(); ++file)
  {
    this->MeshFile(file, console);
  }
  return this->Tally.Conclude(console, "have no surface");
}

Segmentation MeshCommand::Read(const std::filesystem::path& input, StructureChoice& choice) const
{
  Segmentation segmentation = ReadSegmentation(input, this->Images.Choice());
  choice = ChooseStructures(segmentation, this->Options.Labels());
  if (this->OutputIsFile() && choice.Found.size() > 1)
  {
    throw InputError(
        input.string() + " has " + std::to_string(choice.Found.size()) +
        " structures, but --output is one file; choose one with --label, or give a folder.");
  }
  return segmentation;
}

void MeshCommand::MeshFile(std::size_t file, Console& console)
{
  const std::filesystem::path input = this->Inputs[file];
  Segmentation segmentation;
  StructureChoice choice;
  try
  {
    segmentation = this->Read(input, choice);
  }
  catch (const InputError& error)
  {
    this->RecordLost(input, {}, FitResult::Outcome::BadInput, error.what(), console);
    return;
  }
  catch (const std::exception& error)
  {
    if (!SaysMemoryIsShort(error))
    {
      throw;
    }
    this->RecordLost(input, {}, FitResult::Outcome::Failed,
                     input.string() + " needs more memory than there is; crop or resample it.",
                     console);
    return;
  }
  for (const std::string& note : segmentation.Remarks())
  {
    console.Note(input.string() + ": " + note);
  }
  for (const StructureChoice::Missing& missing : choice.Lost)
  {
    this->RecordLost(input, missing.Structure, FitResult::Outcome::BadInput, missing.Message,
                     console);
  }
  const double part = 1.0 / static_cast<double>(this->Inputs.size() * choice.Found.size());
  double done = static_cast<double>(file) / static_cast<double>(this->Inputs.size());
  std::size_t number = 0;
  for (const Segment& structure : choice.Found)
  {
    const std::string title =
        this->Inputs.size() > 1 ? ShortTitle(structure) : CaseTitle(input, structure);
    Case one{input,
             structure,
             segmentation.Layers[static_cast<std::size_t>(structure.Layer)],
             this->Output,
             this->Inputs.size() == 1 && choice.Found.size() == 1 && choice.Lost.empty(),
             done,
             done + part,
             OfFile(file + 1, this->Inputs, CountedCase(++number, choice.Found.size(), title))};
    if (!this->OutputIsFile())
    {
      one.Output /= this->Names.Take(file, structure) + ".vtp";
    }
    done += part;
    this->MeshCase(one, console);
  }
}

void MeshCommand::MeshCase(const Case& one, Console& console)
{
  FitResult::Outcome blame = FitResult::Outcome::BadInput;
  try
  {
    const vtkSmartPointer<vtkSegmentationSurface> surface = this->SurfaceOf(one, console);
    // For a single case, a refused output is treated as a bad command line.
    blame = one.IsOnly ? FitResult::Outcome::BadInput : FitResult::Outcome::Failed;
    if (!this->OutputIsFile())
    {
      MakeOutputFolder(this->Output);
    }
    WriteSurface(one.Output, surface->GetOutput());
    this->RecordWritten(one, surface, console);
  }
  catch (const InputError& error)
  {
    this->RecordLost(one.Input, one.Structure, blame, error.what(), console);
  }
  catch (const std::exception& error)
  {
    if (!SaysMemoryIsShort(error))
    {
      throw;
    }
    this->RecordLost(one.Input, one.Structure, FitResult::Outcome::Failed,
                     "needs more memory than there is; crop or resample the image", console);
  }
}

vtkSmartPointer<vtkSegmentationSurface> MeshCommand::SurfaceOf(const Case& one,
                                                               Console& console) const
{
  auto surface = vtkSmartPointer<vtkSegmentationSurface>::New();
  surface->SetInputData(one.Layer);
  surface->SetLabel(one.Structure.Value);
  Configure(surface, this->Settings);
  try
  {
    RunFilter(surface, one.Title, one.From, one.To, ProgressOn(console));
  }
  catch (const FilterError& error)
  {
    // The structure is the cause: too thin, or without the component asked for.
    throw InputError(error.what());
  }
  if (const std::string reason = TooFewVoxels(surface->GetMaskVolume(), one.Layer); !reason.empty())
  {
    throw InputError(WithHint(reason, HintForTooFewVoxels()));
  }
  return surface;
}

void MeshCommand::RecordWritten(const Case& one, vtkSegmentationSurface* surface, Console& console)
{
  this->Tally.Add(FitResult::Outcome::Fitted);
  console.EndProgress();
  if (this->Json)
  {
    JsonObject result{{JsonSchemaKey, JsonSchemaVersion},
                      {"input", one.Input.string()},
                      {"label", one.Structure.Label},
                      {"name", one.Structure.Name}};
    result["status"] = "written";
    result["output"] = one.Output.string();
    result.update(Describe(surface));
    console.Output() << result.dump(-1, ' ', false, JsonObject::error_handler_t::replace) << '\n';
    return;
  }
  console.Output() << CaseTitle(one.Input, one.Structure) << ": "
                   << surface->GetOutput()->GetNumberOfPolys() << " triangles, "
                   << FixedText(surface->GetSurfaceVolume() / CubicMillimetersPerMilliliter, 3)
                   << " ml (mask "
                   << FixedText(surface->GetMaskVolume() / CubicMillimetersPerMilliliter, 3)
                   << " ml)" << (surface->GetTouchesBorder() ? ", closed at the border" : "")
                   << ", in " << Printable(one.Output.string()) << '\n';
}

void MeshCommand::RecordLost(const std::filesystem::path& input, const Segment& structure,
                             FitResult::Outcome state, const std::string& reason, Console& console)
{
  this->Tally.Add(state);
  const std::string message = CaseMessage(input, structure, reason);
  console.EndProgress();
  console.Error(message);
  if (this->Json)
  {
    JsonObject result{{JsonSchemaKey, JsonSchemaVersion}, {"input", input.string()}};
    result["label"] = structure.Label == 0 ? JsonObject() : JsonObject(structure.Label);
    result["name"] = structure.Name;
    result["status"] = TextOf(state).Word;
    result["message"] = message;
    console.Output() << result.dump(-1, ' ', false, JsonObject::error_handler_t::replace) << '\n';
  }
}
} // namespace palpate::cli
