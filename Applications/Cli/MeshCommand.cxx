#include "MeshCommand.h"

#include "Console.h"
#include "FilterRun.h"
#include "FitFiles.h"
#include "FitResult.h"
#include "FitStructure.h"
#include "InputError.h"
#include "Interruption.h"
#include "SurfaceFile.h"
#include "TextTable.h"
#include "vtkNew.h"
#include "vtkSegmentationSurface.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>
#include <system_error>

namespace palpate::cli
{
namespace
{
using JsonObject = nlohmann::ordered_json;

constexpr double CubicMillimetersPerMilliliter = 1000.0;

std::string TitleOf(const std::filesystem::path& input, const Segment& structure)
{
  const std::string title =
      input.filename().string() + ", label " + std::to_string(structure.Label);
  return structure.Name.empty() ? title : title + " (" + structure.Name + ")";
}

std::vector<Segment> Choose(const Segmentation& segmentation, const std::vector<std::string>& words)
{
  if (words.empty())
  {
    return segmentation.Segments;
  }
  std::vector<Segment> chosen;
  for (const std::string& word : words)
  {
    chosen.push_back(segmentation.Find(word));
  }
  return chosen;
}

void Configure(vtkSegmentationSurface* surface, const FitSettings& settings)
{
  surface->SetMethod(settings.Method == FitSettings::SurfaceMethod::Plain
                         ? vtkSegmentationSurface::PLAIN
                         : vtkSegmentationSurface::SHAPE_INTERPOLATION);
  surface->SetSmoothing(settings.Smoothing);
  surface->SetComponent(settings.Component);
}

// One name for one structure of one file, as `palpate fit` names its folders.
std::filesystem::path FileName(const std::filesystem::path& input, const Segment& structure)
{
  FitResult named;
  named.CaseName = CaseNameOf(input);
  named.Structure = structure;
  return CaseFolderName(named) + ".vtp";
}

void MakeFolder(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
  {
    throw InputError(folder.string() +
                     " cannot be made as a folder; choose another --output, or end it as a "
                     "surface file does (.vtp, .stl, .ply, .obj, .gltf, .glb, .x3d).");
  }
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
         "  palpate mesh a.nii.gz b.nii.gz --output surfaces   every structure, a .vtp each";
}

void MeshCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("MASK", this->Inputs, "Segmentations: label maps, .seg.nrrd, DICOM-SEG")
      ->required();
  this->Options.DeclareLabels(app);
  this->Options.DeclareSurface(app);
  app.add_option("--output", this->Output,
                 "Surface file (.vtp, .stl, .ply, .obj, .gltf, .glb, .x3d) for one structure, or a "
                 "folder for several")
      ->type_name("FILE|DIR")
      ->required();
  app.add_flag("--json", this->Json, "One JSON object a structure on standard output");
}

bool MeshCommand::OutputIsFile() const
{
  return IsSurfaceFile(this->Output);
}

int MeshCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Settings = this->Options.Settings();
  if (this->OutputIsFile() && this->Inputs.size() > 1)
  {
    throw InputError("--output " + this->Output.string() + " is one file, and there are " +
                     std::to_string(this->Inputs.size()) + " masks; give a folder.");
  }
  if (!this->OutputIsFile())
  {
    MakeFolder(this->Output);
  }
  Tally tally;
  try
  {
    for (std::size_t file = 0; file < this->Inputs.size(); ++file)
    {
      this->MeshFile(file, console, tally);
    }
  }
  catch (const Cancelled&)
  {
    console.Error("cancelled; the surfaces that were finished are kept");
    return 1;
  }
  if (tally.BadInputs + tally.Failures == 0)
  {
    return 0;
  }
  if (tally.Cases > 1)
  {
    console.Error(std::to_string(tally.BadInputs + tally.Failures) + " of " +
                  std::to_string(tally.Cases) + " cases have no surface");
  }
  return tally.Cases == 1 && tally.BadInputs == 1 ? 2 : 1;
}

Segmentation MeshCommand::Read(const std::filesystem::path& input,
                               std::vector<Segment>& structures) const
{
  Segmentation segmentation = ReadSegmentation(input);
  structures = Choose(segmentation, this->Options.Labels());
  if (this->OutputIsFile() && structures.size() > 1)
  {
    throw InputError(input.string() + " has " + std::to_string(structures.size()) +
                     " structures and --output is one file; name one with --label, or give a "
                     "folder.");
  }
  return segmentation;
}

void MeshCommand::MeshFile(std::size_t file, Console& console, Tally& tally) const
{
  const std::filesystem::path input = this->Inputs[file];
  Segmentation segmentation;
  std::vector<Segment> structures;
  try
  {
    segmentation = this->Read(input, structures);
  }
  catch (const InputError& error)
  {
    ++tally.Cases;
    ++tally.BadInputs;
    this->Report(input, nullptr, error.what(), console);
    return;
  }
  for (const std::string& note : segmentation.Notes)
  {
    console.Note(note);
  }
  const double files = static_cast<double>(this->Inputs.size());
  const double parts = files * static_cast<double>(structures.size());
  for (std::size_t s = 0; s < structures.size(); ++s)
  {
    const double from = static_cast<double>(file) / files + static_cast<double>(s) / parts;
    this->MeshCase(input, segmentation, structures[s], from, from + 1.0 / parts, console, tally);
  }
}

void MeshCommand::MeshCase(const std::filesystem::path& input, const Segmentation& segmentation,
                           const Segment& structure, double from, double to, Console& console,
                           Tally& tally) const
{
  ++tally.Cases;
  try
  {
    this->MeshStructure(input, segmentation, structure, from, to, console);
  }
  catch (const InputError& error)
  {
    ++tally.BadInputs;
    this->Report(input, &structure, error.what(), console);
  }
  catch (const FilterError& error)
  {
    ++tally.Failures;
    this->Report(input, &structure, TitleOf(input, structure) + ": " + error.what(), console);
  }
}

void MeshCommand::MeshStructure(const std::filesystem::path& input,
                                const Segmentation& segmentation, const Segment& structure,
                                double from, double to, Console& console) const
{
  vtkNew<vtkSegmentationSurface> surface;
  surface->SetInputData(segmentation.Layers[static_cast<std::size_t>(structure.Layer)]);
  surface->SetLabel(structure.Value);
  Configure(surface, this->Settings);
  const std::string title = TitleOf(input, structure);
  RunFilter(surface, title, from, to,
            [&console](double fraction, const std::string& stage)
            {
              console.Progress(fraction, stage);
              return !Interruption::WasAsked();
            });
  const std::filesystem::path output =
      this->OutputIsFile() ? this->Output : this->Output / FileName(input, structure);
  WriteSurface(output, surface->GetOutput());
  console.EndProgress();
  if (this->Json)
  {
    JsonObject result{
        {"input", input.string()}, {"label", structure.Label}, {"name", structure.Name}};
    result["status"] = "written";
    result["output"] = output.string();
    result.update(Describe(surface));
    console.Output() << result.dump(-1, ' ', false, JsonObject::error_handler_t::replace) << '\n';
    return;
  }
  console.Output() << title << ": " << surface->GetOutput()->GetNumberOfPolys() << " triangles, "
                   << TextTable::Fixed(surface->GetSurfaceVolume() / CubicMillimetersPerMilliliter,
                                       3)
                   << " ml (mask "
                   << TextTable::Fixed(surface->GetMaskVolume() / CubicMillimetersPerMilliliter, 3)
                   << " ml)" << (surface->GetTouchesBorder() ? ", closed at the border" : "")
                   << ", in " << output.string() << '\n';
}

void MeshCommand::Report(const std::filesystem::path& input, const Segment* structure,
                         const std::string& sentence, Console& console) const
{
  console.EndProgress();
  console.Error(sentence);
  if (this->Json)
  {
    JsonObject result{{"input", input.string()}};
    if (structure != nullptr)
    {
      result["label"] = structure->Label;
      result["name"] = structure->Name;
    }
    result["status"] = "failed";
    result["message"] = sentence;
    console.Output() << result.dump(-1, ' ', false, JsonObject::error_handler_t::replace) << '\n';
  }
}
} // namespace palpate::cli
