#include "BuiltInRepresentations.h"

#include "DecimalText.h"
#include "ElasticRepresentation.h"
#include "OwnCopy.h"
#include "SceneLabels.h"
#include "SceneReading.h"
#include "SceneRegion.h"
#include "StructurePlan.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string_view>

namespace palpate
{
namespace
{
SceneProduct ModelContactOf(const FitResult& fit, RadialContactMode mode)
{
  return std::make_shared<const TouchContact>(MakeModelContact(fit.Model, mode, fit.Input));
}

// Only a sphere can touch it. The degree of a model is its own.
std::vector<ContactSetting> VaryHarmonics(ContactSetting standard, const TouchToolSettings& tool,
                                          int highestDegree)
{
  if (tool.Kind != TouchToolSettings::Shape::Sphere)
  {
    return {};
  }
  SceneStructure& structure = standard.Structure;
  std::vector<ContactSetting> settings;
  if (structure.Source() != SceneSource::Model)
  {
    structure.Degree = std::min(structure.Degree, highestDegree);
    settings.push_back(standard);
    for (const int degree : {4, 8, 12, 16, 24, 32})
    {
      settings.push_back(standard);
      settings.back().Structure.Degree = std::min(degree, highestDegree);
    }
  }
  settings.push_back(standard);
  for (const RadialContactMode mode : {RadialContactMode::Nearest, RadialContactMode::Radial})
  {
    settings.push_back(standard);
    settings.back().Structure.Mode = mode;
  }
  return Unique(settings);
}

// A model has its own degree.
std::string DegreeText(const ContactSetting& setting, const std::string& before)
{
  const bool isModel = setting.Structure.Source() == SceneSource::Model;
  return isModel ? std::string() : before + std::to_string(setting.Structure.Degree);
}

bool IsNearest(const ContactSetting& setting)
{
  return setting.Structure.Mode == RadialContactMode::Nearest;
}

void PlanContactOfModel(StructurePlan& plan)
{
  const RadialContactMode mode = plan.Settings().Mode;
  plan.AddContact(SceneKey("harmonics", static_cast<int>(mode)), plan.AddModel(),
                  [mode](const StructurePlan::Inputs& inputs, const ProgressFunction&)
                  { return ModelContactOf(*ProductAs<FitResult>(inputs.data()), mode); });
}

// A model from a file yields if it says so.
void PlanModelContact(StructurePlan& plan)
{
  const RadialContactMode mode = plan.Settings().Mode;
  plan.AddContact(SceneKey("model", static_cast<int>(mode)), plan.AddModel(),
                  [mode](const StructurePlan::Inputs& inputs, const ProgressFunction&)
                  {
                    const auto fit = ProductAs<FitResult>(inputs.data());
                    return fit->Elasticity != nullptr
                               ? std::make_shared<const TouchContact>(ElasticContactOf(*fit))
                               : ModelContactOf(*fit, mode);
                  });
}

SceneProduct FacetContactOf(const FitResult& found)
{
  return std::make_shared<const TouchContact>(
      MakeFacetContact(OwnCopy(found.Surface.Get()), found.Input));
}

void PlanFacetContact(StructurePlan& plan)
{
  plan.AddContact("facets", plan.AddSurface(),
                  [](const StructurePlan::Inputs& inputs, const ProgressFunction&)
                  { return FacetContactOf(ProductAs<FitSurface>(inputs.data())->Found); });
}

template <typename T>
std::string_view AsBytes(const T* data, std::size_t count)
{
  return {reinterpret_cast<const char*>(data), count * sizeof(T)};
}

ContentDigest VoxelsOf(vtkImageData* image, const FieldGrid& grid)
{
  vtkDataArray& voxels = *image->GetPointData()->GetScalars();
  const auto count = static_cast<std::size_t>(voxels.GetNumberOfTuples());
  ContentDigest digest;
  digest.Add(AsBytes(static_cast<const char*>(voxels.GetVoidPointer(0)),
                     count * static_cast<std::size_t>(voxels.GetDataTypeSize())));
  digest.Add(AsBytes(grid.Size().data(), grid.Size().size()));
  digest.Add(AsBytes(grid.OriginWorld().data(), 3));
  digest.Add(AsBytes(grid.Spacing().data(), 3));
  return digest;
}

// A drilled structure also keeps the image that it was made from.
SceneProduct FieldContactOf(const SceneStructure& structure, const StructurePlan::Inputs& inputs)
{
  const auto field = ProductAs<ScalarField>(inputs.data());
  TouchContact contact = MakeFieldContact(field, 0, structure.File);
  if (!structure.Iso && field->Smoothing() < structure.Smoothing)
  {
    contact.Represented +=
        ", smoothed by " + FixedText(field->Smoothing(), 2) + " voxels only, since it is thin";
  }
  if (inputs.size() > 1)
  {
    contact.Drilled.Field = field;
    if (const auto read = ProductAs<Segmentation>(&inputs[1]))
    {
      const Segment& segment = SegmentOf(structure, *read);
      contact.Drilled.Image = read->Layers[static_cast<std::size_t>(segment.Layer)];
      contact.Drilled.Label = segment.Value;
    }
    else if (const auto volume = ProductAs<Volume>(&inputs[1]); structure.IsLimited())
    {
      // The values of a region's image mean nothing to the user: drilling gives a label map.
      contact.Drilled.Image = LabelsOfRegion(volume->Image);
      contact.Drilled.Label = 1;
    }
    else
    {
      contact.Drilled.Image = volume->Image;
    }
    contact.Drilled.Voxels = VoxelsOf(contact.Drilled.Image, field->Grid());
  }
  return std::make_shared<const TouchContact>(std::move(contact));
}

std::vector<ContactSetting> VaryField(const ContactSetting& standard, const TouchToolSettings& tool,
                                      int /*highestDegree*/)
{
  constexpr int FinePoints = 98; // of a tool
  std::vector<ContactSetting> settings{standard};
  for (const FieldInterpolation interpolation :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    settings.push_back(standard);
    settings.back().Structure.Interpolation = interpolation;
  }
  const bool isPoint = tool.Kind == TouchToolSettings::Shape::Sphere && tool.Radius == 0.0;
  if (!isPoint)
  {
    for (const int points : {6, 26, FinePoints, 200})
    {
      settings.push_back(standard);
      settings.back().ToolPoints = points;
    }
    // A more accurate field is noticeable only with a finer tool.
    settings.push_back(standard);
    settings.back().Structure.Interpolation = FieldInterpolation::TricubicBSpline;
    settings.back().ToolPoints = FinePoints;
  }
  return Unique(settings);
}

bool IsLinear(const ContactSetting& setting)
{
  return setting.Structure.Interpolation == FieldInterpolation::Trilinear;
}

std::vector<SceneSource> AllSources()
{
  return {SceneSource::Label, SceneSource::IsoValue, SceneSource::Model, SceneSource::Surface};
}

void PlanBySource(StructurePlan& plan)
{
  switch (plan.Settings().Source())
  {
  case SceneSource::Model:
    return PlanModelContact(plan);
  case SceneSource::Surface:
    return PlanFacetContact(plan);
  default:
    return PlanFieldContact(plan);
  }
}

// "prostate: touched by its sub-voxel field, because it is not star-shaped: ..."
std::string AdviceOf(const SceneStructure& structure, const std::string& instead,
                     const std::string& reason)
{
  const bool isPredicate = reason.rfind("is ", 0) == 0 || reason.rfind("has ", 0) == 0;
  return TitleOf(structure) + ": " + instead + ", because " + (isPredicate ? "it " : "") + reason;
}

// Harmonics, or the field once any of their steps has failed.
void PlanModelOrField(StructurePlan& plan)
{
  const SceneStructure& structure = plan.Settings();
  const std::string surface = plan.AddSurface();
  const std::string model = plan.AddModel();
  const std::size_t last = plan.NodeCount();
  const std::string reason = plan.FirstFailure();
  if (reason.empty())
  {
    if (structure.IsTouchable && plan.Find(model) != nullptr)
    {
      PlanContactOfModel(plan);
    }
    else if (structure.IsTouchable)
    {
      plan.AddUndecidedContact(model);
    }
    return;
  }
  const SceneProduct* made = plan.Find(surface);
  const bool hasSurface = made == nullptr || ReasonOf(*made).empty();
  std::string instead = "displayed as the surface of its mask";
  std::string replacement = surface;
  if (structure.IsTouchable || !hasSurface)
  {
    replacement = plan.AddField();
    instead = structure.IsTouchable ? "touched by its sub-voxel field"
                                    : "displayed by its sub-voxel field";
  }
  if (structure.IsTouchable)
  {
    PlanFieldContact(plan);
  }
  plan.Replace(last, replacement, AdviceOf(structure, instead, reason));
}
} // namespace

void PlanFieldContact(StructurePlan& plan)
{
  plan.AddContact(
      "field", plan.AddField(),
      [structure = plan.Settings()](const StructurePlan::Inputs& inputs, const ProgressFunction&)
      { return FieldContactOf(structure, inputs); });
}

SceneRepresentation ModelRepresentation()
{
  SceneRepresentation harmonics;
  harmonics.Name = harmonics.Label = TouchRepresentation::Harmonics;
  harmonics.Sources = {SceneSource::Label, SceneSource::Model, SceneSource::Surface};
  harmonics.Appearance = SceneAppearance::Model;
  harmonics.PlanContact = PlanContactOfModel;
  harmonics.PlanDisplay = [](StructurePlan& plan) { plan.AddModel(); };
  harmonics.Describe = [](const ContactSetting& setting)
  {
    return "harmonics" + DegreeText(setting, " of degree ") +
           (IsNearest(setting) ? ", nearest point" : ", radial");
  };
  harmonics.KeyOf = [](const ContactSetting& setting) {
    return "harmonics" + DegreeText(setting, "/") + (IsNearest(setting) ? "/nearest" : "/radial");
  };
  harmonics.Vary = VaryHarmonics;
  return harmonics;
}

SceneRepresentation FacetRepresentation()
{
  SceneRepresentation facets;
  facets.Name = facets.Label = TouchRepresentation::Facets;
  facets.Sources = {SceneSource::Label, SceneSource::Surface};
  facets.PlanContact = PlanFacetContact;
  facets.Describe = [](const ContactSetting&) { return std::string("facets"); };
  facets.KeyOf = [](const ContactSetting&) { return std::string("facets/all"); };
  facets.Vary = [](const ContactSetting& standard, const TouchToolSettings& tool, int)
  {
    const bool isSphere = tool.Kind == TouchToolSettings::Shape::Sphere; // no other can touch them
    return isSphere ? std::vector<ContactSetting>{standard} : std::vector<ContactSetting>();
  };
  return facets;
}

SceneRepresentation FieldRepresentation()
{
  SceneRepresentation field;
  field.Name = field.Label = TouchRepresentation::SubVoxel;
  field.Sources = {SceneSource::Label, SceneSource::IsoValue};
  field.CanBeDrilled = true;
  field.Appearance = SceneAppearance::SubVoxel;
  field.PlanContact = PlanFieldContact;
  field.Describe = [](const ContactSetting& setting)
  {
    return std::string("sub-voxel, ") + (IsLinear(setting) ? "trilinear, " : "tricubic, ") +
           (setting.ToolPoints > 0 ? std::to_string(setting.ToolPoints) : "enough") +
           " tool points";
  };
  field.KeyOf = [](const ContactSetting& setting)
  {
    return std::string("sub-voxel/") + (IsLinear(setting) ? "linear/" : "cubic/") +
           std::to_string(setting.ToolPoints);
  };
  field.Vary = VaryField;
  return field;
}

SceneRepresentation AutomaticRepresentation()
{
  SceneRepresentation automatic;
  automatic.Name = automatic.Label = TouchRepresentation::Automatic;
  automatic.Sources = AllSources();
  automatic.CanBeDrilled = true;
  automatic.Appearance = SceneAppearance::SubVoxel;
  automatic.PlanContact = PlanBySource;
  return automatic;
}

SceneRepresentation ModelOrFieldRepresentation()
{
  SceneRepresentation either;
  either.Name = TouchRepresentation::ModelOrField;
  either.Label = "model or field";
  either.Sources = AllSources();
  either.Appearance = SceneAppearance::Model;
  either.PlanContact = [](StructurePlan& plan)
  { plan.Settings().Source() == SceneSource::Label ? PlanModelOrField(plan) : PlanBySource(plan); };
  either.PlanDisplay = PlanModelOrField;
  return either;
}
} // namespace palpate
