#include "RenderCommand.h"

#include "CommandProgress.h"
#include "Console.h"
#include "FileType.h"
#include "FilterRun.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
#include "MaskFolders.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "SceneField.h"
#include "ScreenText.h"
#include "SegmentationFile.h"
#include "StructureChoice.h"
#include "SurfaceFile.h"
#include "VolumeFile.h"
#include "WholeFile.h"

#include "vtkNew.h"
#include "vtkSegmentationSurface.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <map>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr int ModelFrequency = 40;
constexpr int LargestSide = 8192; // pixels

// Colours that colour-blind people can tell apart (Okabe and Ito 2008), the organ's first.
constexpr std::array<SceneRenderer::Color, 7> Palette{{{{0.85, 0.66, 0.55}},
                                                       {{0.34, 0.71, 0.91}},
                                                       {{0.90, 0.62, 0.00}},
                                                       {{0.00, 0.62, 0.45}},
                                                       {{0.80, 0.47, 0.65}},
                                                       {{0.94, 0.89, 0.26}},
                                                       {{0.84, 0.37, 0.00}}}};

const std::map<std::string, ViewSide>& Sides()
{
  static const std::map<std::string, ViewSide> sides{
      {"anterior", ViewSide::Anterior}, {"posterior", ViewSide::Posterior},
      {"left", ViewSide::Left},         {"right", ViewSide::Right},
      {"superior", ViewSide::Superior}, {"inferior", ViewSide::Inferior}};
  return sides;
}

const std::map<std::string, SceneRenderer::Plane>& Planes()
{
  static const std::map<std::string, SceneRenderer::Plane> planes{
      {"axial", SceneRenderer::Plane::Axial},
      {"sagittal", SceneRenderer::Plane::Sagittal},
      {"coronal", SceneRenderer::Plane::Coronal}};
  return planes;
}

SceneRenderer::Color ParseColor(const std::string& word)
{
  if (word == "white" || word == "black")
  {
    const double value = word == "white" ? 1.0 : 0.0;
    return {{value, value, value}};
  }
  unsigned int code = 0;
  const char* end = word.data() + word.size();
  if (word.size() != 7 || word.front() != '#' ||
      std::from_chars(word.data() + 1, end, code, 16).ptr != end)
  {
    throw InputError("--background " + word + " is not a colour; give white, black, or #rrggbb");
  }
  return {{(code >> 16U & 255U) / 255.0, (code >> 8U & 255U) / 255.0, (code & 255U) / 255.0}};
}

// The structures that words name. Throws InputError if one is missing.
std::vector<Segment> Found(const Segmentation& segmentation, const std::vector<std::string>& words)
{
  const StructureChoice choice = ChooseStructures(segmentation, words);
  if (!choice.Lost.empty())
  {
    throw InputError(choice.Lost.front().Message);
  }
  return choice.Found;
}

// Structures in groups of at most `most`, the limit of a field.
std::vector<std::vector<Segment>> Groups(const std::vector<Segment>& structures, std::size_t most)
{
  std::vector<std::vector<Segment>> groups;
  for (const Segment& structure : structures)
  {
    if (groups.empty() || groups.back().size() >= most)
    {
      groups.emplace_back();
    }
    groups.back().push_back(structure);
  }
  return groups;
}

std::vector<SceneRenderer::Color> ColorsOf(const std::vector<Segment>& structures)
{
  std::vector<SceneRenderer::Color> colors;
  colors.reserve(structures.size());
  std::transform(structures.begin(), structures.end(), std::back_inserter(colors),
                 [](const Segment& structure) { return structure.Color; });
  return colors;
}

// Makes a field. A failure is blamed on the file or the options.
template <typename Make>
std::shared_ptr<const ScalarField> Field(const std::filesystem::path& file, Console& console,
                                         const Make& make)
{
  try
  {
    auto field = make();
    console.EndProgress();
    return field;
  }
  catch (const FilterError& error)
  {
    const std::string message = error.what();
    const bool namesFile = message.rfind(file.string(), 0) == 0;
    throw InputError(namesFile ? message : file.string() + ": " + message);
  }
}
} // namespace

std::string RenderCommand::Examples() const
{
  return "  palpate render out/model.vtp --array DistanceToSurface --output errors.png\n"
         "  palpate render mask.seg.nrrd --volume t2.nrrd --slices axial --output gland.png\n"
         "  palpate render --volume head-ct.nii.gz --iso 300 --output skull.png\n"
         "  palpate render --volume ct.nrrd --iso 300 --within bones.seg.nrrd --output bones.png\n"
         "  palpate render model.json surface.stl --opacity 0.5 --view left --output both.png\n"
         "Draws with OpenGL; on a machine without a display, run it under xvfb-run -a.";
}

void RenderCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("FILE", this->Inputs,
                 "Surfaces (" + ListOfEndings(SurfaceFormats().ReadEndings()) + "), models (" +
                     ListOfEndings(ReadableModelEndings()) +
                     "), segmentations, or a folder of them")
      ->check(FileType::Input("geometry"));
  app.add_option("--output", this->Output, "PNG file to write")
      ->type_name("FILE")
      ->required()
      ->check(FileType::Output("image", ".png"));
  this->Options.DeclareLabels(app);
  app.add_option("--volume", this->VolumePath, "Draw slices or iso-surfaces of this image")
      ->check(FileType::Input("image"));
  this->Images.Declare(app, "--volume folder");
  app.add_option("--slices", this->Slices,
                 "Slices of --volume through the centre of the drawing: axial, sagittal, coronal "
                 "(default: all, and none with --iso)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"axial", "sagittal", "coronal"}));
  app.add_option("--iso", this->IsoValues,
                 "Draw iso-surfaces of --volume at these values, by the ray caster that touch uses")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(FiniteNumber::Any());
  app.add_option("--within", this->WithinPath, "Draw --iso only within this segmentation")
      ->type_name("FILE")
      ->check(FileType::Input("label"));
  app.add_option("--within-label", this->WithinLabels,
                 "Structures of --within by number or name, separated by commas (default: all)")
      ->type_name("N|NAME")
      ->allow_extra_args(false);
  app.add_flag("--sub-voxel", this->IsSubVoxel,
               "Draw segmentations by that ray caster too, instead of as triangles");
  app.add_option("--interpolation", this->Interpolation,
                 "Interpolation between voxels, for --iso and --sub-voxel: linear, or cubic "
                 "(smoother, slower)")
      ->check(CLI::IsMember({"linear", "cubic"}))
      ->capture_default_str();
  app.add_option("--smoothing", this->Smoothing,
                 "Smoothing of structures for --sub-voxel and --within, in voxels (0: no voxel "
                 "changes sides; increase it where voxels show)")
      ->check(FiniteNumber::Between(0.0, 8.0))
      ->capture_default_str();
  this->DeclareLook(app);
}

void RenderCommand::DeclareLook(CLI::App& app)
{
  app.add_option("--view", this->View, "Side to look at")
      ->check(CLI::IsMember(
          {"anterior", "posterior", "left", "right", "superior", "inferior", "oblique"}))
      ->capture_default_str();
  app.add_option("--size", this->Size, "Width and height in pixels")
      ->delimiter('x')
      ->check(CLI::Range(16, LargestSide))
      ->type_name("WxH")
      ->default_str("800x800");
  app.add_option("--array", this->ArrayName,
                 "Colour surfaces by this point array, e.g. DistanceToSurface");
  app.add_option("--opacity", this->Opacity, "Opacity of the surfaces")
      ->check(FiniteNumber::Between(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--background", this->Background, "Background colour: white, black or #rrggbb")
      ->type_name("COLOR")
      ->capture_default_str();
}

SceneRenderer::Color RenderCommand::NextColor()
{
  return Palette[this->ColorCount++ % Palette.size()];
}

FieldInterpolation RenderCommand::FieldKind() const
{
  return this->Interpolation == "cubic" ? FieldInterpolation::TricubicBSpline
                                        : FieldInterpolation::Trilinear;
}

void RenderCommand::AddMeshes(const Segmentation& segmentation,
                              const std::vector<Segment>& structures, SceneRenderer& scene,
                              Console& console) const
{
  for (const Segment& structure : structures)
  {
    vtkNew<vtkSegmentationSurface> surface;
    surface->SetInputData(segmentation.Layers[static_cast<std::size_t>(structure.Layer)]);
    surface->SetLabel(structure.Value);
    surface->SetComponent(0);
    RunFilter(surface,
              segmentation.Source.filename().string() + ", label " +
                  std::to_string(structure.Label),
              0.0, 1.0, ProgressOn(console));
    scene.AddSurface(surface->GetOutput(), structure.Color, this->Opacity);
  }
}

void RenderCommand::AddFields(const Segmentation& segmentation,
                              const std::vector<Segment>& structures, SceneRenderer& scene,
                              Console& console) const
{
  for (const std::vector<Segment>& some : Groups(structures, MostMaterials))
  {
    scene.AddField(Field(segmentation.Source, console,
                         [&]
                         {
                           return MakeSegmentField(segmentation, some, this->FieldKind(),
                                                   this->Smoothing, ProgressOn(console));
                         }),
                   ColorsOf(some), this->Opacity);
  }
}

void RenderCommand::AddSegmentation(const std::filesystem::path& file, SceneRenderer& scene,
                                    Console& console)
{
  const Segmentation segmentation = ReadSegmentation(file, this->Images.LeftHanded());
  const std::vector<Segment> structures = Found(segmentation, this->Options.Labels());
  this->IsSubVoxel ? this->AddFields(segmentation, structures, scene, console)
                   : this->AddMeshes(segmentation, structures, scene, console);
  console.EndProgress();
}

void RenderCommand::AddFile(const std::filesystem::path& file, SceneRenderer& scene,
                            Console& console)
{
  if (IsModelFile(file))
  {
    scene.AddSurface(DrawModel(ReadModel(file).Surface, ModelFrequency), this->NextColor(),
                     this->Opacity);
  }
  else if (IsSurfaceFile(file))
  {
    scene.AddSurface(ReadSurface(file), this->NextColor(), this->Opacity);
  }
  else
  {
    this->AddSegmentation(file, scene, console);
  }
}

void RenderCommand::TakeFile(const std::filesystem::path& file, SceneRenderer& scene,
                             CaseTally& tally, Console& console)
{
  try
  {
    this->AddFile(file, scene, console);
    tally.Add(FitResult::Outcome::Fitted);
  }
  catch (const InputError& error)
  {
    // One bad file among many leaves the others.
    console.EndProgress();
    console.Error(error.what());
    tally.Add(FitResult::Outcome::BadInput);
  }
  catch (const FilterError& error)
  {
    console.EndProgress();
    console.Error(file.string() + ": " + error.what());
    tally.Add(FitResult::Outcome::BadInput);
  }
}

void RenderCommand::AddIsoSurfaces(vtkImageData* image, SceneRenderer& scene, Console& console)
{
  std::vector<SceneRenderer::Color> colors;
  for (std::size_t i = 0; i < this->IsoValues.size(); ++i)
  {
    colors.push_back(this->NextColor());
  }
  scene.AddField(Field(this->VolumePath, console,
                       [&] {
                         return MakeIsoField(image, this->IsoValues, this->FieldKind(),
                                             ProgressOn(console));
                       }),
                 colors, this->Opacity);
}

void RenderCommand::AddIsoSurfacesWithin(vtkImageData* image, SceneRenderer& scene,
                                         Console& console) const
{
  const Segmentation segmentation = ReadSegmentation(this->WithinPath, this->Images.LeftHanded());
  const std::vector<Segment> structures = Found(segmentation, this->WithinLabels);
  for (const double iso : this->IsoValues)
  {
    for (const std::vector<Segment>& some : Groups(structures, MostMaterials))
    {
      scene.AddField(Field(this->VolumePath + " within " + this->WithinPath, console,
                           [&]
                           {
                             return MakeIsoFieldWithin(image, iso, segmentation, some,
                                                       this->FieldKind(), this->Smoothing,
                                                       ProgressOn(console));
                           }),
                     ColorsOf(some), this->Opacity);
    }
  }
}

void RenderCommand::AddVolume(SceneRenderer& scene, Console& console)
{
  const Volume volume = ReadVolume(this->VolumePath, this->Images.Choice());
  if (!this->IsoValues.empty())
  {
    this->WithinPath.empty() ? this->AddIsoSurfaces(volume.Image, scene, console)
                             : this->AddIsoSurfacesWithin(volume.Image, scene, console);
  }
  // Opaque iso-surfaces would hide slices, so these are drawn only if asked for.
  const std::vector<std::string> every{"axial", "sagittal", "coronal"};
  const bool isPlain = this->Slices.empty() && this->IsoValues.empty();
  const Vector3 middle =
      this->Inputs.empty() && isPlain ? Vector3(volume.Image->GetCenter()) : scene.CenterWorld();
  for (const std::string& word : isPlain ? every : this->Slices)
  {
    scene.AddSlice(volume.Image, Planes().at(word), middle);
  }
}

void RenderCommand::ColorByArray(SceneRenderer& scene) const
{
  if (!scene.ColorByArray(this->ArrayName))
  {
    const std::vector<std::string> names = scene.ArrayNames();
    std::string list;
    for (const std::string& name : names)
    {
      list += (list.empty() ? "" : ", ") + name;
    }
    throw InputError(
        "--array " + this->ArrayName + ": no surface has a point array of this name" +
        (names.empty() ? "; none has an array, leave the option out" : "; available: " + list));
  }
}

int RenderCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Inputs = WithMasksOfFolders(this->Inputs);
  const auto [width, height] = this->Size;
  const SceneRenderer::Color background = ParseColor(this->Background);
  if (this->Output.extension() != ".png")
  {
    throw InputError("--output " + this->Output.string() +
                     " does not end in .png; only PNG files can be written");
  }
  if (!this->IsoValues.empty() && this->VolumePath.empty())
  {
    throw InputError("--iso needs an image; name one with --volume");
  }
  if (this->IsoValues.empty() && !this->WithinPath.empty())
  {
    throw InputError("--within needs an iso-surface to limit; give its value with --iso");
  }
  if (this->WithinPath.empty() && !this->WithinLabels.empty())
  {
    throw InputError("--within-label needs a segmentation; name it with --within");
  }
  if (this->Inputs.empty() && this->VolumePath.empty())
  {
    throw InputError(
        "nothing to draw; name a surface, a model or a segmentation, or an image with --volume");
  }
  SceneRenderer scene;
  scene.SetBackground(background);
  CaseTally tally;
  for (const std::string& input : this->Inputs)
  {
    this->TakeFile(input, scene, tally, console);
  }
  if (tally.Cases > 0 && tally.Lost() == tally.Cases)
  {
    return tally.Conclude(console, "cannot be drawn");
  }
  if (!this->ArrayName.empty())
  {
    this->ColorByArray(scene);
  }
  if (!this->VolumePath.empty())
  {
    this->AddVolume(scene, console);
  }
  const auto side = Sides().find(this->View);
  const ViewFrame frame = side == Sides().end() ? ObliqueFrame() : FrameOf(side->second);
  WriteWholeFile(this->Output, EncodePng(scene.Render(frame, width, height)));
  console.Output() << Printable(this->Output.string()) << ": " << width << " x " << height
                   << " pixels\n";
  return tally.Conclude(console, "are not drawn");
}
} // namespace palpate::cli
