#include "ElasticRepresentation.h"

#include "CaseText.h"
#include "ModelSoftening.h"
#include "Progress.h"
#include "SceneLabels.h"
#include "SceneReading.h"
#include "SceneTissue.h"
#include "StructurePlan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// Everything that a structure is softened by, except its images, which are inputs of the node.
struct Recipe
{
  SofteningSettings Settings;
  bool HasElastography = false;
  std::vector<SceneStructure> Inclusions;
  std::vector<SceneStructure> Neighbours;
};

// The model with its elasticity. `inputs`: the model, the elastography image, and the segmentations
// of inclusions and of neighbours.
SceneProduct Soften(Recipe recipe, const StructurePlan::Inputs& inputs,
                    const ProgressFunction& progress)
{
  const auto fit = ProductAs<FitResult>(inputs.data());
  if (fit->Elasticity != nullptr)
  {
    return fit;
  }
  std::size_t next = 1;
  if (recipe.HasElastography)
  {
    recipe.Settings.Elastography = ProductAs<Volume>(&inputs[next++]);
  }
  for (const SceneStructure& structure : recipe.Inclusions)
  {
    SofteningSettings::Inclusion inclusion;
    inclusion.Read = ProductAs<Segmentation>(&inputs[next++]);
    inclusion.Segments = SegmentsOf(structure, *inclusion.Read);
    inclusion.Kilopascal = structure.Number(TissueKey::Inclusion);
    recipe.Settings.Inclusions.push_back(std::move(inclusion));
  }
  for (const SceneStructure& structure : recipe.Neighbours)
  {
    SofteningSettings::Neighbour neighbour;
    neighbour.Read = ProductAs<Segmentation>(&inputs[next++]);
    neighbour.Segments = SegmentsOf(structure, *neighbour.Read);
    neighbour.KilopascalPerMillimeter = structure.Number(TissueKey::Neighbour);
    recipe.Settings.Neighbours.push_back(std::move(neighbour));
  }
  const std::shared_ptr<const SofteningCache> cache = SofteningCache::OfProcess();
  ModelSoftness softness = SoftenModel(fit->Model, CaseTitle(fit->Input, fit->Structure),
                                       recipe.Settings, progress, cache.get());
  auto softened = std::make_shared<FitResult>(*fit);
  softened->Elasticity = std::move(softness.Elasticity);
  softened->Tissue = std::move(softness.Tissue);
  softened->Notes = std::move(softness.Notes);
  return std::shared_ptr<const FitResult>(std::move(softened));
}

// How much of the inclusions lies in a structure. `inputs`: the model, and the segmentation of
// each.
SceneProduct Place(const std::vector<SceneStructure>& inclusions,
                   const StructurePlan::Inputs& inputs, const ProgressFunction& progress)
{
  auto placed = std::make_shared<SceneInclusions>();
  const auto fit = ProductAs<FitResult>(inputs.data());
  const RadialModel* model = fit->Radial();
  const bool isSoftened = model != nullptr && fit->Elasticity == nullptr;
  for (std::size_t i = 0; isSoftened && i < inclusions.size(); ++i)
  {
    ReportProgress(progress, static_cast<double>(i) / static_cast<double>(inclusions.size()),
                   "inclusions");
    const auto read = ProductAs<Segmentation>(&inputs[i + 1]);
    const std::vector<Segment> segments = SegmentsOf(inclusions[i], *read);
    placed->Shares.emplace_back(inclusions[i].Id,
                                ShareOf(*model, *read, segments, FractionsOf(*read, segments)));
  }
  return std::shared_ptr<const SceneInclusions>(std::move(placed));
}

std::string KeyOfLabels(std::string key, const SceneStructure& structure)
{
  for (const std::string& label : structure.Labels)
  {
    key = SceneKey(key, label);
  }
  return key;
}

// Adds the comparison of the structure with the scene's inclusions, which does not depend on their
// moduli; returns its key.
std::string AddInclusions(StructurePlan& plan, const std::string& model,
                          const std::vector<const SceneStructure*>& inclusions)
{
  std::vector<std::string> inputs{model};
  std::vector<SceneStructure> structures;
  std::string key = SceneKey(model, "inclusions");
  for (const SceneStructure* inclusion : inclusions)
  {
    inputs.push_back(plan.AddSegmentationOf(*inclusion));
    structures.push_back(*inclusion);
    key = KeyOfLabels(SceneKey(key, inclusion->Id, inputs.back()), *inclusion);
  }
  return plan.AddNode(SceneStep::Inclusions, key, std::move(inputs),
                      [structures = std::move(structures)](const StructurePlan::Inputs& made,
                                                           const ProgressFunction& progress)
                      { return Place(structures, made, progress); });
}

// A planned softening.
struct Planned
{
  std::string Key;      // empty if it is not decided yet
  std::string WaitsFor; // key of what decides it
};

// The key has only what the softening depends on, so that other numbers, and inclusions elsewhere,
// do not repeat it.
Planned PlanElasticity(StructurePlan& plan)
{
  const SceneStructure& structure = plan.Settings();
  const std::string model = plan.AddModel();
  const std::vector<const SceneStructure*> inclusions =
      SurroundingsOf(plan.Whole(), structure, TissueKey::Inclusion);
  std::shared_ptr<const SceneInclusions> placed;
  if (!inclusions.empty())
  {
    const std::string placing = AddInclusions(plan, model, inclusions);
    placed = ProductAs<SceneInclusions>(plan.Find(placing));
    if (placed == nullptr)
    {
      plan.AddNode(SceneStep::Elasticity, {}, {placing}, nullptr);
      return {{}, placing};
    }
  }
  Recipe recipe;
  recipe.Settings = SofteningSettingsOf(structure);
  std::vector<std::string> inputs{model};
  std::string key = SceneKey(model, "elasticity");
  for (const SceneNumber& number : TissueNumbers())
  {
    const bool isOfMaps = number.Key == TissueKey::MapDegree;
    key = SceneKey(key,
                   isOfMaps ? recipe.Settings.Numbers.Maps.Degree : structure.Number(number.Key));
  }
  const std::filesystem::path elastography = structure.Image(TissueKey::Elastography);
  if (!elastography.empty())
  {
    recipe.HasElastography = true;
    inputs.push_back(plan.AddImage(elastography));
    key = SceneKey(key, "elastography", inputs.back());
  }
  const auto add =
      [&](const char* name, const SceneStructure& one, std::vector<SceneStructure>& surroundings)
  {
    surroundings.push_back(one);
    inputs.push_back(plan.AddSegmentationOf(one));
    key = KeyOfLabels(SceneKey(key, name, inputs.back(), one.Number(name)), one);
  };
  for (const SceneStructure* inclusion : inclusions)
  {
    if (placed->Has(inclusion->Id))
    {
      add(TissueKey::Inclusion, *inclusion, recipe.Inclusions);
    }
  }
  for (const SceneStructure* one : SurroundingsOf(plan.Whole(), structure, TissueKey::Neighbour))
  {
    add(TissueKey::Neighbour, *one, recipe.Neighbours);
  }
  return {plan.AddNode(SceneStep::Elasticity, key, std::move(inputs),
                       [recipe = std::move(recipe)](const StructurePlan::Inputs& made,
                                                    const ProgressFunction& progress)
                       { return Soften(recipe, made, progress); }),
          {}};
}

void PlanElasticContact(StructurePlan& plan)
{
  const Planned elasticity = PlanElasticity(plan);
  if (elasticity.Key.empty())
  {
    plan.AddUndecidedContact(elasticity.WaitsFor);
    return;
  }
  const auto asked = static_cast<int>(plan.Settings().Number(TissueKey::MapDegree));
  const int degree = asked > 0 ? asked : ComplianceMaps::MostDegree;
  plan.AddContact(
      "elastic", elasticity.Key,
      [degree](const StructurePlan::Inputs& inputs, const ProgressFunction&) -> SceneProduct
      {
        return std::make_shared<const TouchContact>(
            ElasticContactOf(*ProductAs<FitResult>(inputs.data()), degree));
      });
}

int EvenUp(double number)
{
  return 2 * static_cast<int>(std::ceil(0.5 * number));
}

// Of the settings that are softened by: the degree of the compliance is what the elements carry, or
// 0 if the surface decides.
OrganSoftening NumbersOf(const SceneStructure& structure)
{
  OrganSoftening numbers = SofteningSettingsOf(structure).Numbers;
  numbers.Degree =
      std::min(numbers.Degree, OrganSoftening::MostDegreePerElement * numbers.ElementsAcross);
  const auto maps = static_cast<int>(structure.Number(TissueKey::MapDegree));
  numbers.Maps.Degree = maps > 0 ? maps : numbers.Maps.Degree;
  return numbers;
}

// With these numbers instead of defaults, so that settings say what they are.
ContactSetting Explicit(ContactSetting setting, const OrganSoftening& numbers)
{
  setting.Structure.SetNumber(TissueKey::Elements, numbers.ElementsAcross);
  setting.Structure.SetNumber(TissueKey::ComplianceDegree, numbers.Degree);
  setting.Structure.SetNumber(TissueKey::MapDegree, numbers.Maps.Degree);
  return setting;
}

// Of a file's maps, fewer degrees.
ContactSetting WithFileMaps(ContactSetting setting, int degree)
{
  setting.Structure.SetNumber(TissueKey::Elements, 0.0);
  setting.Structure.SetNumber(TissueKey::ComplianceDegree, 0.0);
  setting.Structure.SetNumber(TissueKey::MapDegree, degree);
  return setting;
}

int MapDegreeOfFile(const ContactSetting& setting, int highestDegree)
{
  return setting.Structure.Source() == SceneSource::Model ? highestDegree : 0;
}

// A part of a degree, at least 1.
int DegreeOf(double part, int whole)
{
  return std::max(1, static_cast<int>(std::lround(part * whole)));
}

constexpr std::array<double, 3> MapParts{{0.8, 0.6, 0.4}};

// What can be varied of a file that says how its model yields.
std::vector<ContactSetting> VaryFileMaps(const ContactSetting& standard, int inFile)
{
  const auto own = static_cast<int>(standard.Structure.Number(TissueKey::MapDegree));
  std::vector<ContactSetting> settings{
      WithFileMaps(standard, own > 0 ? std::min(own, inFile) : inFile),
      WithFileMaps(standard, inFile)};
  for (const double part : MapParts)
  {
    settings.push_back(WithFileMaps(standard, DegreeOf(part, inFile)));
  }
  return Unique(settings);
}

// Around the scene's own numbers, so that the measurement takes in proportion to the time that its
// user accepts. Only a sphere can touch what yields.
std::vector<ContactSetting> VaryElastic(const ContactSetting& standard,
                                        const TouchToolSettings& tool, int highestDegree)
{
  if (tool.Kind != TouchToolSettings::Shape::Sphere)
  {
    return {};
  }
  if (const int inFile = MapDegreeOfFile(standard, highestDegree))
  {
    return VaryFileMaps(standard, inFile);
  }
  constexpr std::array<double, 2> ElementParts{{0.75, 0.5}};
  constexpr std::array<double, 2> DegreeParts{{4.0 / 3.0, 2.0 / 3.0}};
  const OrganSoftening numbers = NumbersOf(standard.Structure);
  const int degree = numbers.Degree > 0
                         ? numbers.Degree
                         : std::min(OrganSoftening::UsualDegree, numbers.ElementsAcross);
  std::vector<ContactSetting> settings{Explicit(standard, numbers)};
  for (const double part : ElementParts)
  {
    ContactSetting fewer = standard;
    const int elements = EvenUp(part * numbers.ElementsAcross);
    fewer.Structure.SetNumber(TissueKey::Elements,
                              std::max(elements, SofteningSettings::FewestElements));
    settings.push_back(Explicit(fewer, NumbersOf(fewer.Structure)));
  }
  for (const double part : DegreeParts)
  {
    OrganSoftening other = numbers;
    other.Degree = std::min({DegreeOf(part, degree), ReducedCompliance::MostDegree,
                             OrganSoftening::MostDegreePerElement * numbers.ElementsAcross});
    settings.push_back(Explicit(standard, other));
  }
  for (const double part : MapParts)
  {
    OrganSoftening other = numbers;
    other.Maps.Degree = DegreeOf(part, numbers.Maps.Degree);
    settings.push_back(Explicit(standard, other));
  }
  return Unique(settings);
}

// What a setting says of each number, if anything.
std::string TextOf(const ContactSetting& setting, const char* key, const std::string& before,
                   const std::string& after = {})
{
  const auto number = static_cast<int>(setting.Structure.Number(key));
  return number > 0 ? before + std::to_string(number) + after : std::string();
}

// A file's maps say nothing of it.
std::string ComplianceTextOf(const ContactSetting& setting, const std::string& before,
                             const std::string& automatic)
{
  const bool isOfFile = setting.Structure.Number(TissueKey::Elements) == 0.0;
  const std::string degree = TextOf(setting, TissueKey::ComplianceDegree, before);
  return degree.empty() && !isOfFile ? automatic : degree;
}
} // namespace

void AddElasticity(StructurePlan& plan)
{
  PlanElasticity(plan);
}

TouchContact ElasticContactOf(const FitResult& fit, int mapDegree)
{
  return MakeElasticContact(fit.Model, fit.Elasticity->Truncated(mapDegree), fit.Tissue, fit.Input);
}

ContactSetting FinestElastic(const ContactSetting& standard, int highestDegree)
{
  if (const int inFile = MapDegreeOfFile(standard, highestDegree))
  {
    return WithFileMaps(standard, inFile);
  }
  constexpr double MoreElements = 1.25;
  constexpr double HigherDegree = 4.0 / 3.0;
  constexpr double HigherMaps = 1.2;
  const auto raised = [](double part, int number, int most)
  { return std::min(most, static_cast<int>(std::lround(part * number))); };
  OrganSoftening numbers = NumbersOf(standard.Structure);
  numbers.ElementsAcross =
      std::min(SofteningSettings::MostElements, EvenUp(MoreElements * numbers.ElementsAcross));
  numbers.Degree = numbers.Degree > 0
                       ? raised(HigherDegree, numbers.Degree, ReducedCompliance::MostDegree)
                       : std::min(OrganSoftening::DegreeInHollows, numbers.ElementsAcross);
  numbers.Maps.Degree = raised(HigherMaps, numbers.Maps.Degree, ComplianceMaps::MostDegree);
  return Explicit(standard, numbers);
}

SceneRepresentation ElasticRepresentation()
{
  SceneRepresentation elastic;
  elastic.Name = elastic.Label = TouchRepresentation::Elastic;
  elastic.Sources = {SceneSource::Label, SceneSource::Model};
  elastic.Appearance = SceneAppearance::Model;
  elastic.Numbers = TissueNumbers();
  constexpr double LongestRelaxation = 100.0;
  elastic.Numbers.push_back({"relaxation_ms", "Relaxation, ms", LongestRelaxation, 1});
  elastic.ImageKey = TissueKey::Elastography;
  elastic.ImageLabel = "Elastography image, kPa";
  elastic.PlanContact = PlanElasticContact;
  elastic.PlanDisplay = [](StructurePlan& plan) { plan.AddModel(); };
  elastic.Describe = [](const ContactSetting& setting)
  {
    return "elastic" + TextOf(setting, TissueKey::Elements, ", ", " elements across") +
           ComplianceTextOf(setting, ", compliance of degree ",
                            ", compliance of automatic degree") +
           TextOf(setting, TissueKey::MapDegree, ", maps of degree ");
  };
  elastic.KeyOf = [](const ContactSetting& setting)
  {
    return "elastic" + TextOf(setting, TissueKey::Elements, "/elements-") +
           ComplianceTextOf(setting, "/compliance-", "/compliance-auto") +
           TextOf(setting, TissueKey::MapDegree, "/maps-");
  };
  elastic.Vary = VaryElastic;
  return elastic;
}
} // namespace palpate
