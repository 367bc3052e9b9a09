#include "TouchStructures.h"

#include "CaseText.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "FitStructure.h"
#include "InputError.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Refusal.h"
#include "SceneField.h"
#include "SceneFiles.h"
#include "SceneIsoSurface.h"
#include "SceneMemory.h"
#include "Servo.h"
#include "StageClock.h"
#include "SurfaceFile.h"
#include "SurfaceTool.h"
#include "TouchStandIns.h"
#include "TouchTexture.h"
#include "VoxelMinimum.h"
#include "vtkSegmentationSurface.h"

#include "vtkNew.h"

#include <memory>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
using Representation = TouchRepresentation;

constexpr const char* NeitherReason = "the scene says that it is neither seen nor touched";
constexpr const char* UnseenReason = "the scene says that it is not seen";
constexpr const char* UntouchedReason = "the scene says that it is not touched";
constexpr const char* NobodyLooks = "nobody looks";

// What an entry of a scene asks for, where somebody looks or not.
struct Needs
{
  Needs(const TouchStructureSettings& settings, bool isSeen)
      : IsTouched(settings.IsTouched), IsDrawn(settings.IsSeen && isSeen),
        IsForbidden(settings.IsForbidden)
  {
    const bool isNeither = !settings.IsSeen && !settings.IsTouched;
    this->WhyNotTouched = isNeither ? NeitherReason : UntouchedReason;
    this->WhyNotDrawn = isNeither ? NeitherReason : settings.IsSeen ? NobodyLooks : UnseenReason;
  }
  bool IsAny() const { return this->IsTouched || this->IsDrawn || this->IsForbidden; }

  bool IsTouched;
  bool IsDrawn;
  bool IsForbidden;
  const char* WhyNotTouched;
  const char* WhyNotDrawn;
};

std::string NameOf(const Segment& structure)
{
  return structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
}

// "file 2 of 3: title", or the title alone where there is one.
std::string Counted(const char* kind, std::size_t index, std::size_t count,
                    const std::string& title)
{
  return count > 1 ? kind + (" " + std::to_string(index + 1)) + " of " + std::to_string(count) +
                         ": " + title
                   : title;
}

std::size_t BytesOf(vtkPolyData& surface)
{
  constexpr std::size_t Kibi = 1024;
  return Kibi * surface.GetActualMemorySize();
}

// Fills the structures of one entry of the settings.
class StructureMaker
{
public:
  StructureMaker(const TouchStructureSettings& settings, const Needs& needs, const ToolShape& tool,
                 SceneFiles& files, SceneMemory& memory, ProgressFunction progress,
                 TouchStructures& made)
      : Settings(settings), Need(needs), Tool(tool), Files(files), Memory(memory),
        Progress(std::move(progress)), Made(made)
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
      this->Expect({Representation::Facets}, "a surface of triangles");
      const vtkSmartPointer<vtkPolyData> surface = this->Files.SurfaceOf(file);
      this->Clock.EndStage("reading");
      if (this->Settings.IsForbidden)
      {
        this->Forbid(file.stem().string(), surface);
      }
      this->AddSurface(surface, file.stem().string());
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

  // Of a structure without contact, `contact` has only its looks.
  void Add(const std::string& name, TouchContact contact)
  {
    TouchableStructure structure;
    structure.Touch.Name = this->Settings.Name.empty() ? name : this->Settings.Name;
    SceneStructureAccount account{structure.Touch.Name, this->Settings.File, {}, {}};
    double seconds = this->Elapsed();
    if (this->Need.IsTouched)
    {
      if (this->Settings.IsDrilled())
      {
        structure.Drilled = this->Source;
        structure.Drilled.Field = this->FieldToDrill(contact);
      }
      else
      {
        AddStandIns(contact, this->Progress);
      }
      const std::size_t bytes = this->AddTouch(contact, structure.Touch);
      structure.Represented = contact.Represented;
      structure.OnDemand = contact.OnDemand;
      structure.Harmonics = contact.Harmonics;
      seconds += this->Elapsed();
      account.Contact = {contact.Represented, bytes, seconds, {}};
      structure.Seconds = seconds;
      seconds = 0.0;
    }
    else
    {
      account.Contact.WhyNot = this->Need.WhyNotTouched;
    }
    account.Drawing.WhyNot = this->Need.IsDrawn ? "" : this->Need.WhyNotDrawn;
    if (this->Need.IsDrawn)
    {
      account.Drawing = this->Draw(contact.Looks);
      structure.Looks = std::move(contact.Looks);
      account.Drawing.Seconds = seconds + this->Elapsed();
    }
    this->Made.Account.Structures.push_back(std::move(account));
    if (this->Need.IsTouched || this->Need.IsDrawn)
    {
      (this->Need.IsTouched ? this->Made.Touched : this->Made.OnlySeen)
          .push_back(std::move(structure));
    }
  }

  // Seconds since the last call.
  double Elapsed()
  {
    this->Clock.EndStage({});
    return this->Stages.back().second;
  }

  // What it occupies.
  std::size_t AddTouch(const TouchContact& contact, TouchStructure& touch)
  {
    touch.Model = contact.Model;
    touch.Coarser =
        this->Settings.IsDrilled() ? std::vector<TouchStandIn>() : StandInsFor(contact, this->Tool);
    touch.Drill = this->Settings.Drill;
    touch.Beneath = contact.Beneath;
    touch.Law = {this->Settings.Stiffness, this->Settings.Damping};
    touch.Friction = this->Settings.Friction;
    touch.Viscosity = this->Settings.Viscosity;
    TouchTexture texture;
    if (this->Settings.Texture > 0.0)
    {
      texture = MakeTouchTexture(*this->Files.VolumeOf(this->Settings.TextureImage),
                                 touch.Model->BoundsWorld(), this->Tool.BoundingRadius(),
                                 this->Settings.Texture, this->Progress);
    }
    touch.Texture = std::move(texture.Feel);
    std::size_t bytes = touch.Model->Bytes() + texture.Bytes;
    for (const TouchStandIn& coarser : contact.Coarser)
    {
      bytes += coarser.Model->Bytes();
    }
    return bytes;
  }

  std::shared_ptr<const ScalarField> FieldToDrill(const TouchContact& contact) const
  {
    if (contact.Looks.Field == nullptr)
    {
      Refuse(this->Settings.File, "cannot be drilled, since it is no image and no segmentation",
             "leave \"drill\" out, or name the voxels that it was made of");
    }
    return contact.Looks.Field;
  }

  // What no drill may remove.
  void Forbid(const std::string& name, vtkPolyData* surface)
  {
    this->Made.Forbidden.emplace_back(this->Settings.Name.empty() ? name : this->Settings.Name,
                                      surface, this->Settings.AlarmDistance);
  }

  // A model becomes the surface that is drawn of it.
  SceneItem Draw(TouchAppearance& looks) const
  {
    if (looks.Field != nullptr)
    {
      return {"rays through the field that is felt", 0, 0.0, {}};
    }
    if (looks.Model != nullptr)
    {
      constexpr int Frequency = 20;
      looks.Surface = DrawModel(*looks.Model, Frequency);
      looks.Model = nullptr;
    }
    return {std::to_string(looks.Surface->GetNumberOfCells()) + " triangles",
            BytesOf(*looks.Surface),
            0.0,
            {}};
  }

  void AddHarmonics(const SphericalHarmonicModel& model, const std::string& name)
  {
    TouchContact contact;
    contact.Looks.Model = std::make_shared<const SphericalHarmonicModel>(model);
    if (this->Need.IsTouched)
    {
      const HarmonicForm form{this->Settings.Mode, this->Settings.Precision};
      contact = this->Memory.IsBounded()
                    ? this->Memory.Take(model, form, this->Settings.File)
                    : MakeHarmonicContact(model, form.Mode, form.Precision, this->Settings.File);
    }
    this->Add(name, std::move(contact));
  }

  void AddModel()
  {
    this->Expect({Representation::Harmonics}, "a model");
    const ModelDocument document = this->Files.ModelOf(this->Settings.File);
    this->Clock.EndStage("reading");
    const auto* model = std::get_if<SphericalHarmonicModel>(&document.Surface);
    if (model == nullptr)
    {
      Refuse(this->Settings.File, "is a parametric surface, which has no radius to touch",
             "write it as a surface (palpate convert) and touch that");
    }
    const std::string name = this->Settings.File.stem().string();
    if (this->Settings.IsForbidden)
    {
      constexpr int Frequency = 40;
      this->Forbid(name, DrawModel(*model, Frequency));
    }
    this->AddHarmonics(*model, name);
  }

  void AddSurface(vtkPolyData* surface, const std::string& name)
  {
    TouchContact contact;
    contact.Looks.Surface = surface;
    this->Add(name, this->Need.IsTouched ? MakeFacetContact(surface, this->Settings.File)
                                         : std::move(contact));
  }

  FieldForm Form() const
  {
    const bool isDrilled = this->Settings.IsDrilled();
    return {isDrilled ? FieldInterpolation::Trilinear : this->Settings.Interpolation,
            this->Settings.Bricks, isDrilled};
  }

  void AddField(const std::shared_ptr<const ScalarField>& field, const std::string& name)
  {
    const bool isWhole = this->Need.IsDrawn || this->Settings.IsDrilled();
    this->Add(name, this->Memory.IsBounded() && !isWhole
                        ? this->Memory.Take(field, this->Settings.File)
                        : MakeFieldContact(field, 0, this->Settings.File));
  }

  void AddIsoSurface()
  {
    this->Expect({Representation::SubVoxel}, "an image");
    const auto volume = this->Files.VolumeOf(this->Settings.File);
    this->Clock.EndStage("reading");
    const std::string name = CaseNameOf(this->Settings.File);
    vtkSmartPointer<vtkPolyData> surface;
    if (!this->Need.IsTouched || this->Settings.IsForbidden)
    {
      surface = MakeIsoSurface(volume->Image, *this->Settings.Iso, this->Progress);
    }
    if (this->Settings.IsForbidden)
    {
      this->Forbid(name, surface);
    }
    if (!this->Need.IsTouched)
    {
      TouchContact looks;
      looks.Looks.Surface = surface;
      return this->Add(name, std::move(looks));
    }
    this->Source.Image = this->Settings.IsDrilled() ? volume->Image : nullptr;
    this->AddField(MakeIsoField(volume->Image, {*this->Settings.Iso}, this->Form(), this->Progress),
                   name);
  }

  void AddSegmentation()
  {
    const auto segmentation = this->Files.SegmentationOf(this->Settings.File);
    this->Clock.EndStage("reading");
    std::vector<Segment> structures = segmentation->Segments;
    if (!this->Settings.Labels.empty())
    {
      structures.clear();
      for (const std::string& label : this->Settings.Labels)
      {
        structures.push_back(segmentation->Find(label));
      }
    }
    const auto count = static_cast<double>(structures.size());
    const ProgressFunction whole = std::move(this->Progress);
    for (std::size_t s = 0; s < structures.size(); ++s)
    {
      const std::string title = Counted("structure", s, structures.size(), NameOf(structures[s]));
      this->Progress = [&](double fraction, const std::string& stage)
      { return whole((static_cast<double>(s) + fraction) / count, title + ": " + stage); };
      this->AddSegment(*segmentation, structures[s]);
    }
    this->Progress = whole;
  }

  void AddSegment(const Segmentation& segmentation, const Segment& structure)
  {
    const std::string name = NameOf(structure);
    if (this->Need.IsTouched || this->Settings.IsForbidden)
    {
      this->RequireVoxels(segmentation, structure);
    }
    if (this->Settings.IsForbidden)
    {
      this->Forbid(name, MakeForbiddenSurface(segmentation, structure, this->Progress));
    }
    // Voxels are drilled by their field, whatever else is chosen.
    const Representation asked =
        this->Settings.IsDrilled() ? Representation::SubVoxel : this->Settings.Representation;
    if (asked == Representation::Harmonics)
    {
      this->AddFit(segmentation, structure, name);
    }
    else if (asked == Representation::Facets || !this->Need.IsTouched)
    {
      this->AddSurface(this->SurfaceOf(segmentation, structure), name);
    }
    else
    {
      if (this->Settings.IsDrilled())
      {
        this->Source.Image = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
        this->Source.Label = structure.Value;
      }
      // A field holds many, but each is looked for in its own box of bricks.
      this->AddField(MakeSegmentField(segmentation, {structure}, this->Form(),
                                      this->Settings.Smoothing, this->Progress),
                     name);
    }
  }

  void RequireVoxels(const Segmentation& segmentation, const Segment& structure) const
  {
    if (const std::string reason = TooFewVoxels(segmentation, structure); !reason.empty())
    {
      throw InputError(
          WithHint(CaseSentence(this->Settings.File, structure, reason), ChooseAnother));
    }
  }

  void AddFit(const Segmentation& segmentation, const Segment& structure, const std::string& name)
  {
    FitSettings settings;
    settings.Degree = this->Settings.Degree;
    const FitResult fit = FitStructure(segmentation, structure, settings, this->Progress);
    if (fit.State != FitResult::Outcome::Fitted)
    {
      // Touching has none of the options that a fit has.
      const bool isRefused = fit.State == FitResult::Outcome::Refused;
      throw InputError(WithHint(
          CaseSentence(this->Settings.File, structure, fit.Message),
          isRefused ? "fit it with palpate fit and touch the model, or leave the representation out"
                    : "leave the representation out"));
    }
    this->AddHarmonics(fit.Model, name);
  }

  vtkSmartPointer<vtkPolyData> SurfaceOf(const Segmentation& segmentation, const Segment& structure)
  {
    vtkNew<vtkSegmentationSurface> surface;
    surface->SetInputData(segmentation.Layers[static_cast<std::size_t>(structure.Layer)]);
    surface->SetLabel(structure.Value);
    RunFilter(surface, "surface", 0.0, 1.0, this->Progress);
    return surface->GetOutput();
  }

  const TouchStructureSettings& Settings;
  const Needs& Need;
  const ToolShape& Tool;
  SceneFiles& Files;
  SceneMemory& Memory;
  ProgressFunction Progress;
  TouchStructures& Made;
  DrillSource Source; // of what is added next, where it is drilled
  std::vector<std::pair<std::string, double>> Stages;
  StageClock Clock{Stages};
};

std::vector<std::filesystem::path> FilesOf(const TouchStructureSettings& settings)
{
  std::vector<std::filesystem::path> files{settings.File};
  if (settings.Texture > 0.0)
  {
    files.push_back(settings.TextureImage);
  }
  return files;
}

// An entry of which nothing is made.
void LeaveOut(const TouchStructureSettings& settings, const Needs& needs, SceneAccount& account)
{
  const std::string name = settings.Name.empty() ? CaseNameOf(settings.File) : settings.Name;
  account.Structures.push_back(
      {name, settings.File, {{}, 0, 0.0, needs.WhyNotTouched}, {{}, 0, 0.0, needs.WhyNotDrawn}});
}

// The files that were named and not read, each once.
void AccountForFiles(const TouchSettings& settings, const SceneFiles& files, SceneAccount& account)
{
  account.Files = files.Accounts();
  std::set<std::filesystem::path> known;
  for (const SceneFileAccount& read : account.Files)
  {
    known.insert(read.File);
  }
  for (const TouchStructureSettings& structure : settings.Structures)
  {
    for (const std::filesystem::path& file : FilesOf(structure))
    {
      if (known.insert(file).second)
      {
        account.Files.push_back({file, {{}, 0, 0.0, "nothing that is made needs it"}});
      }
    }
  }
}
} // namespace

TouchStructures MakeTouchStructures(const TouchSettings& settings, bool isSeen,
                                    const ProgressFunction& progress)
{
  TouchStructures made;
  SceneFiles files;
  for (const TouchStructureSettings& structure : settings.Structures)
  {
    for (const std::filesystem::path& file : FilesOf(structure))
    {
      files.Expect(file);
    }
  }
  const ToolShape tool = MakeTool(settings.Tool);
  SceneMemory memory(settings.MemoryMegabytes, tool);
  const auto count = static_cast<double>(settings.Structures.size());
  for (std::size_t s = 0; s < settings.Structures.size(); ++s)
  {
    const TouchStructureSettings& structure = settings.Structures[s];
    const Needs needs(structure, isSeen);
    const std::string base = structure.File.filename().string();
    const std::string title =
        Counted("file", s, settings.Structures.size(),
                structure.Name.empty() ? base : base + " (" + structure.Name + ")");
    const auto part = [&, s](double fraction, const std::string& stage)
    { return progress((static_cast<double>(s) + fraction) / count, title + ", " + stage); };
    needs.IsAny() ? StructureMaker(structure, needs, tool, files, memory, part, made).Run()
                  : LeaveOut(structure, needs, made.Account);
    for (const std::filesystem::path& file : FilesOf(structure))
    {
      files.Done(file);
    }
  }
  AccountForFiles(settings, files, made.Account);
  memory.Share(made);
  return made;
}

SceneItem AccountForServo(const TouchStructures& made, const TouchSettings& settings)
{
  if (made.Touched.empty())
  {
    return {{}, 0, 0.0, "nothing of the scene is touched"};
  }
  auto scene = std::make_shared<TouchScene>();
  scene->Tool = MakeTool(settings.Tool);
  for (const TouchableStructure& structure : made.Touched)
  {
    scene->Structures.push_back(structure.Touch);
  }
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  std::unique_ptr<ServoScene> servo;
  RequireInput(ServoScene::Make(std::move(scene), ServoSettings().VelocityTimeConstant, servo));
  clock.EndStage({});
  return {"trackers and an index", servo->Bytes(), stages.front().second, {}};
}

ToolShape MakeTool(const TouchToolSettings& settings)
{
  const int points = ShellPointsOf(settings);
  ToolShape tool = ToolShape::Sphere(settings.Radius);
  if (settings.Kind == TouchToolSettings::Shape::Capsule)
  {
    tool = ToolShape::Capsule(settings.Radius, settings.Length, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Ellipsoid)
  {
    tool = ToolShape::Ellipsoid(settings.SemiAxes, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Cylinder)
  {
    tool = ToolShape::Cylinder(settings.Radius, settings.Length, points);
  }
  else if (settings.Kind == TouchToolSettings::Shape::Surface)
  {
    tool = SurfaceOf(settings, false)->Touching(points);
  }
  else if (settings.Points > 0)
  {
    tool = ToolShape::SpherePoints(settings.Radius, settings.Points);
  }
  RequireInput(tool.Check(), "the tool cannot touch");
  return tool;
}
} // namespace palpate
