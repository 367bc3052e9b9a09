#include "StructurePlan.h"

#include "BuiltInRepresentations.h"
#include "CaseText.h"
#include "ElasticRepresentation.h"
#include "FilterRun.h"
#include "GuideDistance.h"
#include "InputError.h"
#include "ProtectedSurface.h"
#include "Refusal.h"
#include "SceneCuts.h"
#include "SceneField.h"
#include "SceneIsoSurface.h"
#include "SceneLabels.h"
#include "SceneReading.h"
#include "SceneRegion.h"
#include "SceneTool.h"
#include "SteadyClock.h"
#include "SurfaceFileFit.h"

#include <algorithm>

namespace palpate
{
namespace
{
std::string CenterKey(const FitSettings& fit)
{
  if (!fit.GivenCenterWorld)
  {
    return std::to_string(static_cast<int>(fit.Center));
  }
  const auto& center = *fit.GivenCenterWorld;
  return SceneKey("at", center[0], center[1], center[2]);
}

// The tool for a product: its surface, if it has one, is the second input.
TouchToolSettings ToolWith(const std::vector<SceneProduct>& inputs, TouchToolSettings settings)
{
  settings.Surface = inputs.size() > 1 ? ProductAs<SurfaceTool>(&inputs[1]) : nullptr;
  return settings;
}

// A contact that has the cuts by the border of the segmentation, which is the second input.
StructurePlan::Making WithCuts(const SceneStructure& structure, StructurePlan::Making make)
{
  return [structure, make = std::move(make)](StructurePlan::Inputs inputs,
                                             const ProgressFunction& progress) -> SceneProduct
  {
    const auto read = ProductAs<Segmentation>(&inputs[1]);
    inputs.resize(1);
    const SceneProduct made = make(inputs, progress);
    TouchContact contact = *ProductAs<TouchContact>(&made);
    contact.Cuts = CutsOf(*read, SegmentOf(structure, *read));
    return std::make_shared<const TouchContact>(std::move(contact));
  };
}

// Adds the name of the structure to a filter's errors.
template <typename Make>
auto OfSegment(const Segmentation& segmentation, const Segment& segment, const Make& make)
{
  try
  {
    return make();
  }
  catch (const FilterError& error)
  {
    throw InputError(CaseMessage(segmentation.Source, segment, error.what()));
  }
}
} // namespace

StructurePlan::StructurePlan(const SceneSettings& scene, const SceneStructure& structure,
                             std::string tool, const SceneStamps& stamps, const SceneLookup& lookup,
                             std::vector<SceneNode>& nodes)
    : Scene(scene), Structure(structure), Stamps(stamps), Lookup(lookup), Nodes(nodes),
      Fit(FitSettingsOf(scene, structure)), Source(structure.Source()), ToolKey(std::move(tool)),
      First(nodes.size())
{
}

void StructurePlan::Add()
{
  if (this->Structure.IsTouchable)
  {
    this->AddRepresentation();
  }
  if (this->Structure.IsVisible)
  {
    this->AddAppearance();
  }
}

// Adds a node only once. A node that is requested again is needed explicitly, so nothing replaces
// it.
std::string StructurePlan::AddNode(SceneStep step, const std::string& key,
                                   std::vector<std::string> inputs, Making make)
{
  const auto own = this->Nodes.begin() + static_cast<std::ptrdiff_t>(this->First);
  const auto there = std::find_if(own, this->Nodes.end(),
                                  [&key](const SceneNode& node) { return node.Key == key; });
  if (there != this->Nodes.end() && !key.empty())
  {
    there->Advice.clear();
    return key;
  }
  SceneNode node;
  node.Step = step;
  node.Id = this->Structure.Id;
  node.Key = key;
  node.Inputs = std::move(inputs);
  node.Make = std::move(make);
  this->Nodes.push_back(std::move(node));
  return key;
}

// For files small enough to be read once per structure.
std::string StructurePlan::AddFile(SceneNode node)
{
  std::string key = SceneKey(node.Key, this->Structure.Id);
  const std::size_t before = this->Nodes.size();
  this->AddNode(node.Step, key, {}, std::move(node.Make));
  if (this->Nodes.size() > before)
  {
    this->Nodes.back().Reads = node.Reads;
  }
  return key;
}

// The node of a file, which another structure may have added before; otherwise it belongs to the
// structure with this id.
std::string StructurePlan::Share(SceneNode node, int id)
{
  const auto there = std::find_if(this->Nodes.begin(), this->Nodes.end(),
                                  [&node](const SceneNode& one) { return one.Key == node.Key; });
  std::string key = node.Key;
  if (there == this->Nodes.end())
  {
    node.Id = id;
    this->Nodes.push_back(std::move(node));
  }
  return key;
}

std::string StructurePlan::AddSegmentation()
{
  return this->AddSegmentationOf(this->Structure);
}

std::string StructurePlan::AddSegmentationOf(const SceneStructure& other)
{
  return this->Share(SegmentationNode(other.File, this->Scene.LeftHanded, this->Stamps, other.Move),
                     other.Id);
}

std::string StructurePlan::AddImage(const std::filesystem::path& file, const std::string& series)
{
  SceneNode node =
      VolumeNode(file, series, this->Scene.LeftHanded, this->Stamps, this->Structure.Move);
  node.Step = SceneStep::Image;
  return this->Share(std::move(node), this->Structure.Id);
}

// The image in which an iso-value bounds the structure: its own, or that of a limited region.
std::string StructurePlan::AddIsoImage()
{
  const SceneStructure& own = this->Structure;
  std::string image = this->AddImage(own.File, own.Series);
  if (!own.IsLimited())
  {
    return image;
  }
  std::vector<std::string> inputs{image};
  if (!own.WithinFile.empty())
  {
    inputs.push_back(this->Share(
        SegmentationNode(own.WithinFile, this->Scene.LeftHanded, this->Stamps, own.Move), own.Id));
  }
  const std::string limit = own.IsoUpper ? SceneKey("to", *own.IsoUpper) : std::string();
  const std::string key =
      SceneKey(image, "region", *own.Iso, limit, inputs.back(), own.WithinLabel);
  return this->AddNode(SceneStep::Image, key, std::move(inputs),
                       [own](const Inputs& made, const ProgressFunction& progress)
                       {
                         const auto mask = made.size() > 1 ? ProductAs<Segmentation>(&made[1])
                                                           : std::shared_ptr<const Segmentation>();
                         return std::make_shared<const Volume>(MakeRegion(
                             own, *ProductAs<Volume>(made.data()), mask.get(), progress));
                       });
}

std::string StructurePlan::AddIsoSurface()
{
  const std::string image = this->AddIsoImage();
  return this->AddNode(SceneStep::Surface, SceneKey(image, "iso-surface", *this->Structure.Iso),
                       {image},
                       [iso = this->IsoOfImage()](const Inputs& inputs,
                                                  const ProgressFunction& progress) -> SceneProduct
                       {
                         const auto volume = ProductAs<Volume>(inputs.data());
                         FitSurface surface;
                         surface.Found.Input = volume->Source;
                         surface.Found.Surface = MakeIsoSurface(volume->Image, iso, progress);
                         return std::make_shared<const FitSurface>(std::move(surface));
                       });
}

std::string StructurePlan::AddSurface()
{
  if (this->Source == SceneSource::Surface)
  {
    return this->AddFile(SurfaceNode(this->Structure.File, this->Stamps, this->Structure.Move));
  }
  if (this->Source == SceneSource::IsoValue)
  {
    return this->AddIsoSurface();
  }
  const std::string segmentation = this->AddSegmentation();
  const std::string key =
      SceneKey(segmentation, "surface", this->Structure.Labels.front(),
               static_cast<int>(this->Fit.Method), this->Fit.Smoothing, this->Fit.Component);
  return this->AddNode(SceneStep::Surface, key, {segmentation},
                       [structure = this->Structure,
                        fit = this->Fit](const Inputs& inputs, const ProgressFunction& progress)
                       {
                         const auto read = ProductAs<Segmentation>(inputs.data());
                         return std::make_shared<const FitSurface>(
                             MakeFitSurface(*read, SegmentOf(structure, *read), fit, progress));
                       });
}

std::string StructurePlan::AddSamples()
{
  const std::string surface = this->AddSurface();
  const std::string key =
      SceneKey(surface, "samples", this->Fit.Rules, static_cast<int>(this->Fit.Model),
               this->Fit.Repairs, this->Fit.IsAlone, this->Fit.Frequency, CenterKey(this->Fit),
               this->Fit.MaximumHiddenPercent, this->Fit.MinimumDice);
  return this->AddNode(SceneStep::Samples, key, {surface},
                       [fit = this->Fit, isTriangles = this->Source != SceneSource::Label](
                           const Inputs& inputs, const ProgressFunction& progress)
                       {
                         auto given = ProductAs<FitSurface>(inputs.data());
                         if (isTriangles)
                         {
                           const FitResult& read = given->Found;
                           given = std::make_shared<const FitSurface>(
                               MakeFitSurface(read.Input, read.Surface, fit, progress));
                         }
                         return std::make_shared<const FitSamples>(
                             MakeFitSamples(*given, fit, progress));
                       });
}

std::string StructurePlan::AddModel()
{
  if (this->Source == SceneSource::Model)
  {
    return this->AddFile(ModelNode(this->Structure.File, this->Stamps, this->Structure.Move));
  }
  const std::string samples = this->AddSamples();
  const FitSettings& fit = this->Fit;
  const std::string key = SceneKey(samples, "model", fit.Degree, fit.Tolerance.value_or(-1.0),
                                   fit.MaximumDegree, static_cast<int>(fit.Weight),
                                   static_cast<int>(fit.PenaltyKind), fit.Roughness, fit.IsRobust);
  return this->AddNode(SceneStep::Model, key, {samples},
                       [fit](const Inputs& inputs, const ProgressFunction& progress)
                       {
                         return std::make_shared<const FitResult>(
                             MakeFitModel(*ProductAs<FitSamples>(inputs.data()), fit, progress));
                       });
}

// For voxels. A drilled structure keeps its inside and is interpolated linearly.
std::string StructurePlan::AddField()
{
  const bool isDrilled = this->Structure.IsDrilled();
  const FieldInterpolation interpolation =
      isDrilled ? FieldInterpolation::Trilinear : this->Structure.Interpolation;
  const FieldForm form(interpolation, isDrilled);
  if (this->Source == SceneSource::IsoValue)
  {
    const std::string image = this->AddIsoImage();
    return this->AddNode(
        SceneStep::Field,
        SceneKey(image, "field", *this->Structure.Iso, static_cast<int>(interpolation), isDrilled),
        {image},
        [iso = this->IsoOfImage(), form](const Inputs& inputs, const ProgressFunction& progress)
        { return MakeIsoField(ProductAs<Volume>(inputs.data())->Image, {iso}, form, progress); });
  }
  const std::string segmentation = this->AddSegmentation();
  const double smoothing = this->Structure.Smoothing;
  return this->AddNode(
      SceneStep::Field,
      SceneKey(segmentation, "field", this->Structure.Labels.front(),
               static_cast<int>(interpolation), smoothing, isDrilled),
      {segmentation},
      [structure = this->Structure, form,
       smoothing](const Inputs& inputs, const ProgressFunction& progress) -> SceneProduct
      {
        const auto read = ProductAs<Segmentation>(inputs.data());
        const Segment& segment = SegmentOf(structure, *read);
        return OfSegment(*read, segment,
                         [&]
                         { return MakeSegmentField(*read, {segment}, form, smoothing, progress); });
      });
}

void StructurePlan::AddRepresentation()
{
  const SceneRepresentation& representation = RepresentationOf(this->Structure);
  if (this->Structure.IsDrilled() && !this->HasVoxels())
  {
    return this->AddRefusal(
        "cannot be drilled, since it is neither an image nor a segmentation",
        "remove \"drill\", or give the image or segmentation that it was made from");
  }
  if (!representation.Takes(this->Source))
  {
    const std::string is = this->Source == SceneSource::Model     ? "a model"
                           : this->Source == SceneSource::Surface ? "a surface of triangles"
                                                                  : "an image";
    return this->AddRefusal("cannot be touched by this representation, since it is " + is,
                            "omit the representation");
  }
  // Drilling requires a field, regardless of the chosen representation.
  this->Structure.IsDrilled() ? PlanFieldContact(*this) : representation.PlanContact(*this);
}

// As it would be touched, except voxels, which are displayed as a surface.
void StructurePlan::AddOnlyDisplayed()
{
  const SceneRepresentation& representation = RepresentationOf(this->Structure);
  if (this->Source == SceneSource::Model)
  {
    this->AddModel();
  }
  else if (this->Source == SceneSource::Label && representation.PlanDisplay)
  {
    representation.PlanDisplay(*this);
  }
  else
  {
    this->AddSurface();
  }
}

void StructurePlan::AddAppearance()
{
  switch (this->Structure.Appearance)
  {
  case SceneAppearance::Automatic:
    if (!this->Structure.IsTouchable)
    {
      this->AddOnlyDisplayed();
    }
    break;
  case SceneAppearance::Model:
  case SceneAppearance::ErrorMap:
    this->AddModel();
    break;
  case SceneAppearance::StiffnessMap:
    if (this->Structure.Representation == TouchRepresentation::Elastic)
    {
      AddElasticity(*this);
    }
    else
    {
      this->AddModel();
    }
    break;
  case SceneAppearance::Surface:
    this->Source == SceneSource::Model ? this->AddModel() : this->AddSurface();
    break;
  case SceneAppearance::SubVoxel:
    if (this->HasVoxels())
    {
      this->AddField();
    }
    else
    {
      this->AddOnlyDisplayed();
    }
    break;
  }
}

// Reason for the failure of one of this structure's nodes; empty if it has not, or not yet, failed.
std::string StructurePlan::ReasonAt(std::size_t node) const
{
  const SceneProduct* product = this->Lookup(this->Nodes[node].Key);
  const bool isOwn = this->Nodes[node].Reads.empty();
  return isOwn && product != nullptr ? ReasonOf(*product) : std::string();
}

std::string StructurePlan::FirstFailure() const
{
  std::string reason;
  for (std::size_t n = this->First; n < this->Nodes.size() && reason.empty(); ++n)
  {
    reason = this->ReasonAt(n);
  }
  return reason;
}

void StructurePlan::Replace(std::size_t last, const std::string& replacement,
                            const std::string& advice)
{
  const SceneProduct* product = this->Lookup(replacement);
  if (product == nullptr || FailureOf(*product).empty())
  {
    for (std::size_t n = this->First; n < last; ++n)
    {
      const bool isOwn = this->Nodes[n].Reads.empty();
      this->Nodes[n].Advice = isOwn ? advice : std::string();
      this->Nodes[n].Replacement = isOwn ? replacement : std::string();
    }
  }
}

void StructurePlan::AddRefusal(const std::string& fact, const std::string& remedy)
{
  this->AddNode(SceneStep::Touch, SceneKey("refusal", this->Structure.Id, fact), {},
                [file = this->Structure.File, fact, remedy](const Inputs&,
                                                            const ProgressFunction&) -> SceneProduct
                { Refuse(file, fact, remedy); });
}

void StructurePlan::AddContact(const std::string& kind, const std::string& input, Making make)
{
  std::vector<std::string> inputs{input};
  std::string key = SceneKey(input, "touch", kind);
  if (this->Structure.IsDrilled())
  {
    inputs.push_back(this->AddVoxels());
  }
  else if (this->Source == SceneSource::Label && !this->Structure.KeepsCuts)
  {
    inputs.push_back(this->AddSegmentation());
    key = SceneKey(key, "cuts");
    make = WithCuts(this->Structure, std::move(make));
  }
  for (const SceneNumber& number : RepresentationOf(this->Structure).Numbers)
  {
    key = SceneKey(key, this->Structure.Number(number.Key));
  }
  this->ContactKey = this->AddNode(SceneStep::Touch, key, std::move(inputs), std::move(make));
  this->AddEffects();
}

void StructurePlan::AddUndecidedContact(const std::string& input)
{
  this->AddNode(SceneStep::Touch, {}, {input}, nullptr);
}

std::string StructurePlan::AddVoxels()
{
  return this->Source == SceneSource::Label ? this->AddSegmentation() : this->AddIsoImage();
}

// Only effects made from images.
void StructurePlan::AddEffects()
{
  std::vector<const SceneEffectKind*> kinds;
  std::vector<std::string> images;
  std::string key = SceneKey(this->WithTool(this->ContactKey), "effects");
  for (const SceneEffectKind* kind : EffectsOf(this->Structure))
  {
    if (!kind->ImageKey.empty())
    {
      kinds.push_back(kind);
      images.push_back(this->AddImage(this->Structure.Image(kind->ImageKey)));
      key = SceneKey(key, kind->Name, images.back());
      for (const SceneNumber& number : kind->Numbers)
      {
        key = SceneKey(key, this->Structure.Number(number.Key));
      }
    }
  }
  if (kinds.empty())
  {
    return;
  }
  std::vector<std::string> inputs{this->ContactKey};
  if (!this->ToolKey.empty())
  {
    inputs.push_back(this->ToolKey);
  }
  inputs.insert(inputs.end(), images.begin(), images.end());
  this->AddNode(SceneStep::Effects, key, std::move(inputs),
                [settings = this->Scene.Tool, structure = this->Structure,
                 kinds](const Inputs& made, const ProgressFunction& progress)
                {
                  const ToolShape tool = MakeTool(ToolWith(made, settings));
                  const auto contact = ProductAs<TouchContact>(made.data());
                  auto effects = std::make_shared<ImageEffects>();
                  for (std::size_t n = 0; n < kinds.size(); ++n)
                  {
                    const auto image = ProductAs<Volume>(&made[made.size() - kinds.size() + n]);
                    effects->Made[kinds[n]->Name] =
                        kinds[n]->Make({structure, image.get(), contact->Model->BoundsWorld(),
                                        tool.BoundingRadius(), contact->Yields},
                                       progress);
                  }
                  return std::shared_ptr<const ImageEffects>(std::move(effects));
                });
}

void StructurePlan::AddCost()
{
  if (!this->Structure.IsTouchable)
  {
    return;
  }
  std::vector<std::string> inputs{this->ContactKey};
  if (!this->ToolKey.empty())
  {
    inputs.push_back(this->ToolKey);
  }
  const bool isDecided = !this->ContactKey.empty();
  this->AddNode(SceneStep::Cost,
                isDecided ? SceneKey(this->WithTool(this->ContactKey), "cost") : std::string(),
                std::move(inputs),
                [settings = this->Scene.Tool](const Inputs& made, const ProgressFunction& progress)
                {
                  const SteadyClock clock;
                  return std::make_shared<const TouchCost>(
                      MeasureTouchCost(*ProductAs<TouchContact>(made.data()),
                                       ToolWith(made, settings), clock, progress));
                });
}

std::string StructurePlan::WithTool(const std::string& start) const
{
  const TouchToolSettings& tool = this->Scene.Tool;
  const Vector3& axes = tool.SemiAxes;
  return SceneKey(start, static_cast<int>(tool.Kind), tool.Radius, tool.Length, axes.x(), axes.y(),
                  axes.z(), tool.Points, this->ToolKey);
}

// The closed surface of the whole structure, regardless of the settings of a fit.
std::string StructurePlan::AddProtectedSurface()
{
  if (this->Source != SceneSource::Label)
  {
    return this->Source == SceneSource::Model ? this->AddModel() : this->AddSurface();
  }
  return this->AddSegmentation();
}

void StructurePlan::AddProtection(const std::vector<std::string>& fields)
{
  std::vector<std::string> inputs{this->AddProtectedSurface()};
  std::string key =
      SceneKey(inputs.front(), "protection",
               this->Source == SceneSource::Label ? this->Structure.Labels.front() : std::string());
  for (const std::string& field : fields)
  {
    const SceneProduct* product = this->Lookup(field);
    if (product == nullptr || FailureOf(*product).empty())
    {
      inputs.push_back(field);
      key = SceneKey(key, field);
    }
  }
  this->AddNode(SceneStep::Protection, key, std::move(inputs),
                [structure = this->Structure](const Inputs& made, const ProgressFunction& progress)
                {
                  constexpr double SurfacePart = 0.2;
                  const vtkSmartPointer<vtkPolyData> surface = ProtectedSurfaceOf(
                      structure, made.front(), PartOf(progress, 0.0, SurfacePart));
                  std::vector<std::shared_ptr<const ScalarField>> drilled;
                  for (std::size_t n = 1; n < made.size(); ++n)
                  {
                    drilled.push_back(ProductAs<ScalarField>(&made[n]));
                  }
                  return std::make_shared<const SceneProtection>(
                      MakeSceneProtection(surface, drilled, PartOf(progress, SurfacePart, 1.0)));
                });
}

void StructurePlan::AddGuide()
{
  const GuideReach reach = ReachOfGuides(this->Scene, this->Structure.Id);
  if (reach.Reach <= 0.0)
  {
    return;
  }
  const std::string surface = this->AddProtectedSurface();
  const std::string label =
      this->Source == SceneSource::Label ? this->Structure.Labels.front() : std::string();
  this->AddNode(
      SceneStep::Guide, SceneKey(surface, "guide", label, reach.Reach, reach.Step), {surface},
      [structure = this->Structure, reach](const Inputs& made, const ProgressFunction& progress)
      { return MakeGuideDistance(structure, made.front(), reach, progress); });
}
} // namespace palpate
