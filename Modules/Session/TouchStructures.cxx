#include "TouchStructures.h"

#include "FilterRun.h"
#include "FitStructure.h"
#include "InputError.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SceneField.h"
#include "StageClock.h"
#include "SurfaceFile.h"
#include "TouchTexture.h"
#include "Volume.h"
#include "vtkSegmentationSurface.h"

#include "vtkNew.h"

#include <utility>

namespace palpate
{
namespace
{
using Representation = TouchRepresentation;

// Fills the structures of one entry of the settings.
class StructureMaker
{
public:
  StructureMaker(const TouchStructureSettings& settings, const ProgressFunction& progress,
                 std::vector<TouchableStructure>& made)
      : Settings(settings), Progress(progress), Made(made)
  {
  }

  void Run()
  {
    const std::filesystem::path& file = this->Settings.File;
    if (this->Settings.Iso)
    {
      this->AddIsoSurface();
    }
    else if (IsModelFile(file))
    {
      this->AddModel();
    }
    else if (IsSurfaceFile(file))
    {
      this->AddSurface(ReadSurface(file), this->Settings.File.stem().string());
    }
    else
    {
      this->AddSegmentation();
    }
  }

private:
  void Expect(std::initializer_list<Representation> possible, const std::string& what) const
  {
    const Representation asked = this->Settings.Representation;
    bool isPossible = asked == Representation::Automatic;
    for (const Representation one : possible)
    {
      isPossible = isPossible || asked == one;
    }
    if (!isPossible)
    {
      Refuse(this->Settings.File, "cannot be touched by this representation, since it is " + what,
             "leave the representation out");
    }
  }

  void Add(const std::string& name, TouchContact contact)
  {
    TouchableStructure structure;
    structure.Looks = std::move(contact.Looks);
    structure.Touch.Name = this->Settings.Name.empty() ? name : this->Settings.Name;
    structure.Touch.Model = std::move(contact.Model);
    structure.Touch.Law = {this->Settings.Stiffness, this->Settings.Damping};
    structure.Touch.Friction = this->Settings.Friction;
    structure.Touch.Viscosity = this->Settings.Viscosity;
    if (this->Settings.Texture > 0.0)
    {
      structure.Touch.Texture =
          MakeTouchTexture(this->Settings.TextureImage, structure.Touch.Model->BoundsWorld(),
                           this->Settings.Texture, this->Progress);
    }
    structure.Represented = std::move(contact.Represented);
    this->Clock.EndStage(structure.Touch.Name);
    structure.Seconds = this->Stages.back().second;
    this->Made.push_back(std::move(structure));
  }

  void AddHarmonics(const SphericalHarmonicModel& model, const std::string& name)
  {
    this->Add(name, MakeHarmonicContact(model, this->Settings.Mode, this->Settings.File));
  }

  void AddModel()
  {
    this->Expect({Representation::Harmonics}, "a model");
    const ModelDocument document = ReadModel(this->Settings.File);
    const auto* model = std::get_if<SphericalHarmonicModel>(&document.Surface);
    if (model == nullptr)
    {
      Refuse(this->Settings.File, "is a parametric surface, which has no radius to touch",
             "write it as a surface (palpate convert) and touch that");
    }
    this->AddHarmonics(*model, this->Settings.File.stem().string());
  }

  void AddSurface(vtkPolyData* surface, const std::string& name)
  {
    this->Expect({Representation::Facets}, "a surface of triangles");
    this->Add(name, MakeFacetContact(surface, this->Settings.File));
  }

  void AddField(const std::shared_ptr<const ScalarField>& field, int material,
                const std::string& name)
  {
    this->Add(name,
              MakeFieldContact(field, material, this->Settings.Interpolation, this->Settings.File));
  }

  void AddIsoSurface()
  {
    this->Expect({Representation::SubVoxel}, "an image");
    const Volume volume = ReadVolume(this->Settings.File);
    this->AddField(MakeIsoField(volume.Image, {*this->Settings.Iso}, this->Settings.Interpolation,
                                this->Progress),
                   0, CaseNameOf(this->Settings.File));
  }

  void AddSegmentation()
  {
    const Segmentation segmentation = ReadSegmentation(this->Settings.File);
    std::vector<Segment> structures = segmentation.Segments;
    if (!this->Settings.Labels.empty())
    {
      structures.clear();
      for (const std::string& label : this->Settings.Labels)
      {
        structures.push_back(segmentation.Find(label));
      }
    }
    for (const Segment& structure : structures)
    {
      this->AddSegment(segmentation, structure);
    }
  }

  void AddSegment(const Segmentation& segmentation, const Segment& structure)
  {
    const std::string name =
        structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
    switch (this->Settings.Representation)
    {
    case Representation::Harmonics:
      return this->AddFit(segmentation, structure, name);
    case Representation::Facets:
      return this->AddMesh(segmentation, structure, name);
    default:
      // A field holds many, but each is looked for in its own box of bricks.
      return this->AddField(MakeSegmentField(segmentation, {structure},
                                             this->Settings.Interpolation, this->Settings.Smoothing,
                                             this->Progress),
                            0, name);
    }
  }

  void AddFit(const Segmentation& segmentation, const Segment& structure, const std::string& name)
  {
    FitSettings settings;
    settings.Degree = this->Settings.Degree;
    const FitResult fit = FitStructure(segmentation, structure, settings, this->Progress);
    if (fit.State != FitResult::Outcome::Fitted)
    {
      throw InputError(this->Settings.File.string() + ", " + name + ": " + fit.Message);
    }
    this->AddHarmonics(fit.Model, name);
  }

  void AddMesh(const Segmentation& segmentation, const Segment& structure, const std::string& name)
  {
    vtkNew<vtkSegmentationSurface> surface;
    surface->SetInputData(segmentation.Layers[static_cast<std::size_t>(structure.Layer)]);
    surface->SetLabel(structure.Value);
    RunFilter(surface, "surface", 0.0, 1.0, this->Progress);
    this->AddSurface(surface->GetOutput(), name);
  }

  const TouchStructureSettings& Settings;
  const ProgressFunction& Progress;
  std::vector<TouchableStructure>& Made;
  std::vector<std::pair<std::string, double>> Stages;
  StageClock Clock{Stages};
};
} // namespace

std::vector<TouchableStructure> MakeTouchStructures(const TouchSettings& settings,
                                                    const ProgressFunction& progress)
{
  std::vector<TouchableStructure> made;
  const auto count = static_cast<double>(settings.Structures.size());
  for (std::size_t s = 0; s < settings.Structures.size(); ++s)
  {
    const auto part = [&, s](double fraction, const std::string& stage)
    { return progress((static_cast<double>(s) + fraction) / count, stage); };
    StructureMaker(settings.Structures[s], part, made).Run();
  }
  return made;
}

ToolShape MakeTool(const TouchToolSettings& settings)
{
  // Enough for the surfaces of organs; a sphere's own number follows from the voxels it touches.
  constexpr int ShellPoints = 200;
  const int points = settings.Points > 0 ? settings.Points : ShellPoints;
  ToolShape tool = ToolShape::Sphere(settings.Radius);
  if (settings.Kind == TouchToolSettings::Shape::Capsule)
  {
    tool = ToolShape::Capsule(settings.Radius, settings.Length, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Ellipsoid)
  {
    tool = ToolShape::Ellipsoid(settings.SemiAxes, points);
  }
  else if (settings.Points > 0)
  {
    tool = ToolShape::SpherePoints(settings.Radius, settings.Points);
  }
  RequireInput(tool.Check(), "the tool cannot touch");
  return tool;
}
} // namespace palpate
